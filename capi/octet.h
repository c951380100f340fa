/* SPDX-License-Identifier: BSD-3-Clause */
/* Octet in C, and in all languages that call C: a CAD part in, a classified tetrahedral mesh out.
 *
 *     const char *words[] = {"--size", "2", "--size-at", "Face12=0.5"};
 *     octet_mesh *mesh;
 *     int status = octet_mesh_file("part.step", words, 4, NULL, NULL, &mesh);
 *     if (status == OCTET_COMPLETE || status == OCTET_INCOMPLETE) ... else puts(octet_error());
 *     octet_free(mesh);
 *
 * Nothing is printed, no signal is caught, no state is kept but the text of each thread's last error. All
 * functions may be called from several threads at once. What a mesh's functions return stays until the mesh
 * is freed, and may be read from any thread.
 */
#ifndef OCTET_H
#define OCTET_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define OCTET_API __attribute__((visibility("default")))
#else
#define OCTET_API
#endif

/* As the program's exit codes. */
enum {
  OCTET_COMPLETE = 0,   /* a mesh, and every claim about it holds */
  OCTET_BAD_INPUT = 2,  /* no mesh: the part, an option, a limit or a path */
  OCTET_INCOMPLETE = 3, /* a mesh, and faults that remain: octet_fault() */
  OCTET_FAILED = 4      /* no mesh: cancelled, out of memory, or a defect of Octet */
};

typedef struct octet_mesh octet_mesh;

/* Called as stages begin, with the share of the whole that is done, from the thread that called; and, with
 * stage NULL and the share before, often between: what is not 0 ends the run. */
typedef int (*octet_progress)(const char *stage, double fraction, void *user);

/* "0.1.0" */
OCTET_API const char *octet_version(void);

/* Why the calling thread's last call that failed did so; in CAD's terms, one line. Stays until its next. */
OCTET_API const char *octet_error(void);

/* Meshes a STEP, IGES or BREP file. `words` are options of `octet mesh` as on its command line, but those
 * that tell of files to write and of what is printed; may be NULL where `count` is 0, as may `progress`.
 * Returns one of the four above. `*mesh` is NULL where there is none. */
OCTET_API int octet_mesh_file(const char *part, const char *const *words, size_t count,
                              octet_progress progress, void *user, octet_mesh **mesh);

/* The same for the bytes of such a file, as a CAD program has them in memory: with BREP (BRepTools::Write)
 * numbers of faces and edges are the program's own (Face%12). */
OCTET_API int octet_mesh_bytes(const void *part, size_t size, const char *const *words, size_t count,
                               octet_progress progress, void *user, octet_mesh **mesh);

/* What `octet info --json` tells of a part: words are options of how it is read. NULL: octet_error(). To be
 * freed by octet_free_text(). */
OCTET_API char *octet_info(const char *part, const char *const *words, size_t count);
OCTET_API void octet_free_text(char *text);

/* OCTET_COMPLETE or OCTET_INCOMPLETE. */
OCTET_API int octet_status(const octet_mesh *mesh);
/* 1 or 2. */
OCTET_API int octet_order(const octet_mesh *mesh);

/* Nodes: x, y, z of each in the unit asked for; dimension and tag of the model entity of least dimension that
 * holds each. */
OCTET_API size_t octet_nodes(const octet_mesh *mesh);
OCTET_API const double *octet_coordinates(const octet_mesh *mesh);
OCTET_API const int32_t *octet_node_entities(const octet_mesh *mesh);

/* Elements of dimension 1 (on model edges), 2 (on model faces, oriented as these) and 3 (positive): how many,
 * nodes of one, nodes of all from 0 in the order of VTK and Abaqus, and tags of the edges, faces or regions
 * that they are on. 0 or NULL for other dimensions. */
OCTET_API size_t octet_elements(const octet_mesh *mesh, int dimension);
OCTET_API int octet_element_nodes(const octet_mesh *mesh, int dimension);
OCTET_API const uint32_t *octet_connectivity(const octet_mesh *mesh, int dimension);
OCTET_API const int32_t *octet_element_tags(const octet_mesh *mesh, int dimension);

/* Model entities of dimension 0 to 3, which have tags from 1 to this; the name that CAD gives to one, ""
 * where it gives none or there is none. */
OCTET_API int octet_entities(const octet_mesh *mesh, int dimension);
OCTET_API const char *octet_entity_name(const octet_mesh *mesh, int dimension, int tag);

/* Faults, a line each: entity, place, cause and advice. NULL beyond the last. */
OCTET_API size_t octet_faults(const octet_mesh *mesh);
OCTET_API const char *octet_fault(const octet_mesh *mesh, size_t number);

/* All that `octet mesh --report` writes, as JSON. */
OCTET_API const char *octet_report(const octet_mesh *mesh);

/* Writes a mesh file; `format` as --format has it, NULL: by the path's suffix. OCTET_COMPLETE where it is
 * written. */
OCTET_API int octet_write(const octet_mesh *mesh, const char *path, const char *format);

/* NULL is no mesh, and nothing to free. */
OCTET_API void octet_free(octet_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
