/* SPDX-License-Identifier: BSD-3-Clause */
/* The interface as a C program uses it.
 *   tests_capi <models> <folder for files> */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "octet.h"

static int failures = 0;

static void expect(int holds, const char *what) {
  if (holds) return;
  fprintf(stderr, "does not hold: %s (last error: %s)\n", what, octet_error());
  ++failures;
}

static char *path_of(const char *folder, const char *name) {
  char *path = malloc(strlen(folder) + strlen(name) + 2);
  sprintf(path, "%s/%s", folder, name);
  return path;
}

static double volume_of(const octet_mesh *mesh) {
  const double *x = octet_coordinates(mesh);
  const uint32_t *nodes = octet_connectivity(mesh, 3);
  const int each = octet_element_nodes(mesh, 3);
  double sum = 0.0;
  size_t t;
  for (t = 0; t < octet_elements(mesh, 3); ++t) {
    const double *a = x + 3 * nodes[t * each], *b = x + 3 * nodes[t * each + 1];
    const double *c = x + 3 * nodes[t * each + 2], *d = x + 3 * nodes[t * each + 3];
    double e[3][3];
    int i;
    for (i = 0; i < 3; ++i) {
      e[0][i] = b[i] - a[i];
      e[1][i] = c[i] - a[i];
      e[2][i] = d[i] - a[i];
    }
    sum += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6.0;
  }
  return sum;
}

struct seen {
  int stages, questions, end_at;
  double last;
};

static int follow(const char *stage, double fraction, void *user) {
  struct seen *seen = user;
  expect(fraction >= seen->last && fraction <= 1.0, "progress goes on");
  seen->last = fraction;
  if (stage != NULL)
    ++seen->stages;
  else
    ++seen->questions;
  return seen->end_at > 0 && seen->stages >= seen->end_at;
}

static void test_box(const char *models) {
  char *part = path_of(models, "box.step");
  const char *words[] = {"--size", "0.5", "--unit", "cm", "--threads", "1"};
  octet_mesh *mesh = NULL;
  struct seen seen = {0, 0, 0, 0.0};
  size_t i;
  expect(octet_mesh_file(part, words, 6, follow, &seen, &mesh) == OCTET_COMPLETE, "a box is meshed");
  if (mesh == NULL) exit(1);
  expect(seen.stages > 5 && seen.questions > 0, "stages are told, and whether to go on is asked");
  expect(octet_status(mesh) == OCTET_COMPLETE && octet_order(mesh) == 1 && octet_faults(mesh) == 0,
         "it is complete");
  expect(octet_fault(mesh, 0) == NULL, "there is no fault");
  expect(fabs(volume_of(mesh) - 6.0) < 1e-9, "6 cm^3");
  expect(octet_entities(mesh, 0) == 8 && octet_entities(mesh, 1) == 12 && octet_entities(mesh, 2) == 6 &&
             octet_entities(mesh, 3) == 1 && octet_entities(mesh, 4) == 0 && octet_entities(mesh, -1) == 0,
         "the box's entities");
  expect(octet_element_nodes(mesh, 1) == 2 && octet_element_nodes(mesh, 2) == 3 &&
             octet_element_nodes(mesh, 3) == 4,
         "nodes of elements");
  expect(octet_elements(mesh, 0) == 0 && octet_elements(mesh, 4) == 0 && octet_connectivity(mesh, 9) == NULL,
         "there are no other elements");
  for (i = 0; i < octet_elements(mesh, 2); ++i) {
    const int32_t face = octet_element_tags(mesh, 2)[i];
    int k;
    expect(face >= 1 && face <= 6, "triangles are on faces");
    for (k = 0; k < 3; ++k) {
      const uint32_t node = octet_connectivity(mesh, 2)[3 * i + k];
      const int32_t *on = octet_node_entities(mesh) + 2 * node;
      expect(node < octet_nodes(mesh) && on[0] <= 2 && (on[0] < 2 || on[1] == face),
             "their nodes are on them");
    }
  }
  expect(strcmp(octet_entity_name(mesh, 2, 7), "") == 0 && strcmp(octet_entity_name(mesh, 5, 1), "") == 0,
         "what is not there has no name");
  expect(strstr(octet_report(mesh), "\"status\": \"complete\"") != NULL, "the report tells");
  octet_free(mesh);
  free(part);
}

static void test_second_order(const char *models, const char *folder) {
  char *part = path_of(models, "bracket.step"), *file = path_of(folder, "library.msh");
  const char *words[] = {"--size=6", "--order=2", "--group", "ends=Face1-2"};
  octet_mesh *mesh = NULL;
  expect(octet_mesh_file(part, words, 4, NULL, NULL, &mesh) == OCTET_COMPLETE, "a bracket is meshed");
  if (mesh == NULL) exit(1);
  expect(octet_order(mesh) == 2 && octet_element_nodes(mesh, 3) == 10 && octet_element_nodes(mesh, 2) == 6 &&
             octet_element_nodes(mesh, 1) == 3,
         "of second order");
  {
    /* Node 5 of a tetrahedron is between its corners 0 and 1, node 10 between 2 and 3; inside they are
     * halfway. */
    const uint32_t *nodes = octet_connectivity(mesh, 3);
    const double *x = octet_coordinates(mesh);
    size_t t, inside = 0;
    for (t = 0; t < octet_elements(mesh, 3); ++t) {
      static const int ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
      int k, i;
      for (k = 0; k < 6; ++k) {
        const uint32_t m = nodes[10 * t + 4 + k];
        if (octet_node_entities(mesh)[2 * m] != 3) continue;
        ++inside;
        for (i = 0; i < 3; ++i)
          expect(fabs(x[3 * m + i] - 0.5 * (x[3 * nodes[10 * t + ends[k][0]] + i] +
                                            x[3 * nodes[10 * t + ends[k][1]] + i])) < 1e-9,
                 "nodes are in the middles of their edges");
      }
    }
    expect(inside > 100, "there are edges inside");
  }
  remove(file);
  expect(octet_write(mesh, file, NULL) == OCTET_COMPLETE, "it is written");
  expect(octet_write(mesh, "/nowhere/at/all.msh", NULL) == OCTET_BAD_INPUT && strlen(octet_error()) > 0,
         "it cannot be written there");
  expect(octet_write(mesh, file, "nonsense") == OCTET_BAD_INPUT && strstr(octet_error(), "nonsense") != NULL,
         "that is no format");
  octet_free(mesh);
  free(file);
  free(part);
}

static void test_bytes(const char *models) {
  char *part = path_of(models, "box.step");
  FILE *file = fopen(part, "rb");
  char *bytes = malloc(1 << 20);
  const size_t size = fread(bytes, 1, 1 << 20, file);
  const char *words[] = {"--size", "5"};
  octet_mesh *mesh = NULL;
  fclose(file);
  expect(octet_mesh_bytes(bytes, size, words, 2, NULL, NULL, &mesh) == OCTET_COMPLETE, "bytes are a part");
  if (mesh == NULL) exit(1);
  expect(fabs(volume_of(mesh) - 6000.0) < 1e-6, "6000 mm^3");
  octet_free(mesh);
  expect(octet_mesh_bytes("no part", 7, words, 2, NULL, NULL, &mesh) == OCTET_BAD_INPUT && mesh == NULL,
         "these are none");
  free(bytes);
  free(part);
}

static void test_failures(const char *models) {
  char *part = path_of(models, "box.step");
  static const struct {
    const char *words[2], *told;
  } wrong[] = {{{"--size", "-1"}, "size"},
               {{"--sise", "1"}, "did you mean --size?"},
               {{"--output", "a.msh"}, "--output"},
               {{"--size-at", "Face77=1"}, "Face77"},
               {{"--size", "1e-9"}, "--max-elements"},
               {{"stray", "words"}, "stray"}};
  octet_mesh *mesh = NULL;
  struct seen seen = {0, 0, 3, 0.0};
  const char *word = NULL;
  size_t i;
  for (i = 0; i < sizeof wrong / sizeof wrong[0]; ++i) {
    expect(octet_mesh_file(part, wrong[i].words, 2, NULL, NULL, &mesh) == OCTET_BAD_INPUT && mesh == NULL,
           wrong[i].told);
    expect(strstr(octet_error(), wrong[i].told) != NULL, wrong[i].told);
  }
  expect(octet_mesh_file("nowhere.step", NULL, 0, NULL, NULL, &mesh) == OCTET_BAD_INPUT, "no such file");
  expect(octet_mesh_file(NULL, NULL, 0, NULL, NULL, &mesh) == OCTET_BAD_INPUT, "no part");
  expect(octet_mesh_file(part, NULL, 0, NULL, NULL, NULL) == OCTET_BAD_INPUT, "no place for the mesh");
  expect(octet_mesh_file(part, &word, 1, NULL, NULL, &mesh) == OCTET_BAD_INPUT, "no word");
  expect(octet_mesh_file(part, NULL, 0, follow, &seen, &mesh) == OCTET_FAILED && mesh == NULL &&
             seen.stages == 3,
         "the caller ends a run");
  octet_free(NULL);
  free(part);
}

static void test_info(const char *models) {
  char *part = path_of(models, "two_boxes.step");
  const char *words[] = {"--no-fuse"}, *wrong[] = {"--size", "1"};
  char *text = octet_info(part, words, 1);
  expect(text != NULL && strstr(text, "\"regions\"") != NULL, "a part is told");
  octet_free_text(text);
  expect(octet_info(part, wrong, 2) == NULL && strstr(octet_error(), "--size") != NULL,
         "a size is none of it");
  free(part);
}

int main(int argc, char **argv) {
  if (argc != 3) return 2;
  expect(strchr(octet_version(), '.') != NULL, "there is a version");
  test_box(argv[1]);
  test_second_order(argv[1], argv[2]);
  test_bytes(argv[1]);
  test_failures(argv[1]);
  test_info(argv[1]);
  if (failures > 0) fprintf(stderr, "%d do not hold\n", failures);
  return failures > 0 ? 1 : 0;
}
