/* SPDX-License-Identifier: BSD-3-Clause */
/* Whether the library for C is found where it was installed, and finds what it needs. */
#include <octet.h>

#include <stdio.h>

int main(int argc, char **argv) {
  const char *words[] = {"--size", "5"};
  octet_mesh *mesh;
  int status;
  if (argc != 2) return 2;
  status = octet_mesh_file(argv[1], words, 2, NULL, NULL, &mesh);
  printf("%s: status %d, %s\n", octet_version(), status, octet_error());
  if (status != OCTET_COMPLETE || octet_elements(mesh, 3) == 0) return 1;
  octet_free(mesh);
  return 0;
}
