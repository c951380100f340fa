// SPDX-License-Identifier: BSD-3-Clause
// Reads a part where OCCT can harm nobody.
#include "geom/occt/reader.h"

#include <unistd.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>
#include <array>
#include <cmath>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geom/face_crossings.h"
#include "geom/face_touches.h"
#include "geom/occt/assemble.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/contact_circle.h"
#include "geom/occt/part_stream.h"
#include "geom/occt/silence.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

std::string do_job(const ReadJob& job, const StageLog& log) {
  const Silence silence;
  try {
    CadDocument document;
    if (job.shape.IsNull()) {
      log("reading the file");
      document = read_document(job.path, job.kind);
    } else {
      document.shape = job.shape;
    }
    const AssembledPart part = assemble(document, job.options, job.touching, log);
    log("handing the part over");
    return encode_part(part.numbering, part.parts);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    throw InputError(std::string("the part cannot be analysed: ") + failure.GetMessageString());
  }
}

std::string encode_job(const ReadJob& job) {
  ByteWriter out;
  out(job.path.string(), job.kind, job.shape.IsNull() ? std::string() : encode_shape(job.shape),
      job.options.facet_deflection, job.options.sew_tolerance, job.options.fuse, job.touching);
  return std::move(out.bytes);
}

fs::path directory_of_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

/// The helper where it may be: asked for, in a build tree, in the tree of an installed program, where it was
/// installed. Empty: nowhere.
fs::path find_helper(const ReadOptions& options) {
  if (!options.reader_program.empty()) return options.reader_program;
  const fs::path here = directory_of_program();
  for (const fs::path& path :
       {here / "octet-reader", here / "../libexec/octet/octet-reader", fs::path(OCTET_READER)})
    if (::access(path.c_str(), X_OK) == 0) return path;
  return {};
}

std::size_t default_memory() {
  const auto pages = static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES));
  return pages / 2 * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::string guarded_bytes(const ReadJob& job, std::string& note) {
  const ReadOptions& options = job.options;
  const auto in_this_process = [&] {
    const OcctLock lock;
    return do_job(job, [](const std::string&) {});
  };
  if (!options.isolate) return in_this_process();
  const ChildLimits limits{options.time_limit,
                           options.memory_limit > 0 ? options.memory_limit : default_memory()};
  if (has_one_thread() && options.reader_program.empty())
    return run_in_child([&](const StageLog& log) { return do_job(job, log); }, limits);
  const fs::path helper = find_helper(options);
  if (!helper.empty()) return run_in_helper(helper, reader_version(), encode_job(job), limits);
  note = "read without limits of time and memory: the program octet-reader was not found";
  return in_this_process();
}

/// Faces that cross bound nothing, with edges there or without: what touches any of those is left as it is.
std::vector<FaceTouch> touches_without_crossings(const Model& model) {
  std::vector<FaceTouch> touches = touching_faces(model, kContactShare * model.diagonal());
  if (touches.empty()) return touches;
  std::set<int> crossed;
  for (const FaceCrossing& crossing : face_crossings(model))
    crossed.insert(crossing.face.begin(), crossing.face.end());
  std::erase_if(touches, [&](const FaceTouch& touch) {
    return crossed.count(touch.face[0]) > 0 || crossed.count(touch.face[1]) > 0;
  });
  return touches;
}

/// Whether a model has all that another one has: faults and volumes tell.
bool is_as_whole(const Model& model, const Model& other) {
  constexpr double kSameVolume = 1e-6;
  const auto volume = [](const Model& of) {
    double sum = 0.0;
    for (int region = 1; region <= of.count(3); ++region) sum += of.region(region).volume;
    return sum;
  };
  return model.parts().faults.size() <= other.parts().faults.size() && model.count(3) >= other.count(3) &&
         std::abs(volume(model) - volume(other)) <= kSameVolume * std::abs(volume(other));
}

}  // namespace

std::string reader_version() { return "Octet " OCTET_VERSION " with OCCT " OCC_VERSION_COMPLETE; }

std::string serve_job(std::string_view request, const StageLog& log) {
  ByteReader in(request);
  ReadJob job;
  std::string path, shape;
  in(path, job.kind, shape, job.options.facet_deflection, job.options.sew_tolerance, job.options.fuse,
     job.touching);
  job.path = path;
  if (!shape.empty()) job.shape = decode_shape(shape);
  return do_job(job, log);
}

ModelParts read_job(const ReadJob& job) {
  std::string note;
  const std::string bytes = guarded_bytes(job, note);
  const OcctLock lock;
  try {
    ModelParts parts = decode_part(bytes);
    if (!note.empty()) parts.notes.push_back(note);
    return parts;
  } catch (const Standard_Failure& failure) {
    throw Bug(std::string("a part that was read cannot be restored: ") + failure.GetMessageString());
  }
}

Model read_model(ReadJob job) {
  Model model(read_job(job));
  const std::vector<FaceTouch> touches = touches_without_crossings(model);
  if (touches.empty()) return model;
  const auto numbers = sources(model.provenance(), 2, model.count(2));
  for (const FaceTouch& touch : touches) {
    const auto &a = numbers[static_cast<std::size_t>(touch.face[0])],
               &b = numbers[static_cast<std::size_t>(touch.face[1])];
    if (!a.empty() && !b.empty()) job.touching.push_back({a.front(), b.front()});
  }
  try {
    Model imprinted(read_job(job));
    if (is_as_whole(imprinted, model)) return imprinted;
  } catch (const Error&) {  // as the file has it, it can be read
  }
  return model;
}

}  // namespace octet
