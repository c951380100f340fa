// SPDX-License-Identifier: BSD-3-Clause
// A shape in memory to a Model.
#include "geom/occt/from_shape.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <Standard_Failure.hxx>
#include <utility>

#include "base/error.h"
#include "geom/occt/cause.h"
#include "geom/occt/reader.h"

namespace octet {

Model model_from_shape(const TopoDS_Shape& shape, const ReadOptions& options, const char* installed_reader) {
  if (shape.IsNull()) throw InputError("the shape is null");
  ReadJob job;
  job.options = options;
  job.installed_reader = installed_reader;
  try {
    // The copy shares the geometry; topology and triangulation are its own.
    job.shape = BRepBuilderAPI_Copy(shape, false, false).Shape();
  } catch (const Standard_Failure& failure) {
    throw InputError("the shape cannot be copied: " + cause_of(failure));
  }
  return read_model(std::move(job));
}

}  // namespace octet
