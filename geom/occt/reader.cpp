// SPDX-License-Identifier: BSD-3-Clause
// Reads a part where OCCT can harm nobody.
#include "geom/occt/reader.h"

#include <fmt/format.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>
#include <algorithm>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/entity_words.h"
#include "base/error.h"
#include "geom/occt/assemble.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/cause.h"
#include "geom/occt/part_stream.h"
#include "geom/occt/piece_file.h"
#include "geom/occt/read_again.h"
#include "geom/occt/silence.h"
#include "geom/occt/sub_shapes.h"
#include "geom/occt/tessellate.h"
#include "geom/occt/time_left.h"

namespace octet {
namespace {

namespace fs = std::filesystem;

/// The error with what the file itself calls the entity that it names.
ModelError with_id(const ModelError& error, const CadDocument& document) {
  const ModelRef entity = error.entity();
  if (!entity.valid()) return error;
  const ShapeMaps as_read(document.shape);
  const std::vector<int> ids = ids_of(as_read.of[entity.dim], document.ids);
  const auto tag = static_cast<std::size_t>(entity.tag);
  if (tag >= ids.size() || ids[tag] == 0) return error;
  return {fmt::format("{}; {} {} is {}{} in the file", error.what(), shape_word(entity.dim), tag,
                      document.id_mark, ids[tag]),
          entity};
}

CadDocument document_of(const ReadJob& job, const StageLog& log) {
  if (job.shape.IsNull()) {
    log("reading the file");
    return read_document(job.path, job.kind);
  }
  CadDocument document;
  document.shape = job.shape;
  return document;
}

struct Assembled {
  IgesReading how;
  std::string note;  ///< of that reading, if it is not the first
  AssembledPart part;
};

/// The first of the other readings of an IGES file that has no faults, and no face less; none: the first that
/// bounds something, or nothing at all. What goes wrong with them is no more than what went wrong before.
std::optional<Assembled> assembled_otherwise(const ReadJob& job, const TopoDS_Shape& shape,
                                             const std::string& error, const StageLog& log) {
  const std::string cause = error.substr(0, error.find(';'));  // without its advice
  std::optional<Assembled> best;
  for (const IgesReading& how : other_readings(shape)) {
    try {
      log("reading the file otherwise");
      CadDocument document = read_document(job.path, job.kind, how);
      if (count_faces(document.shape) < count_faces(shape)) continue;
      const std::string note = note_of(how, cause);
      document.notes.push_back(note);
      AssembledPart part = assemble(document, job.options, {}, log);
      const bool faultless = part.parts.faults.empty();
      if (!best || faultless) best = Assembled{how, note, std::move(part)};
      if (faultless) break;
    } catch (const InputError&) {
    } catch (const Standard_Failure&) {
    }
  }
  return best;
}

/// Each reading takes as long as the first.
bool may_be_read_otherwise(const ReadJob& job, const TopoDS_Shape& shape) {
  constexpr int kMostFaces = 2000;
  return job.shape.IsNull() && job.kind == FileKind::kIges && count_faces(shape) <= kMostFaces;
}

/// Without faces that meet.
Assembled assembled(const ReadJob& job, const CadDocument& document, const StageLog& log) {
  const bool otherwise = may_be_read_otherwise(job, document.shape);
  try {
    AssembledPart part = assemble(document, job.options, {}, log);
    if (otherwise && !part.parts.faults.empty()) {
      std::optional<Assembled> other =
          assembled_otherwise(job, document.shape, part.parts.faults.front().cause, log);
      if (other && other->part.parts.faults.empty()) return *std::move(other);
    }
    return {{}, {}, std::move(part)};
  } catch (const ModelError& error) {
    if (otherwise)
      if (auto other = assembled_otherwise(job, document.shape, error.what(), log)) return *std::move(other);
    throw;
  }
}

/// The document whose numbers the model has: of an IGES file perhaps not that of the first reading.
CadDocument document_of_model(const ReadJob& job, const StageLog& log) {
  CadDocument document = document_of(job, log);
  if (!may_be_read_otherwise(job, document.shape)) return document;
  IgesReading how;
  std::string note;
  try {
    const Assembled first = assembled(job, document, log);
    how = first.how;
    note = first.note;
  } catch (const ModelError&) {
  }
  // Once more, for what has been assembled is not as it was read.
  document = read_document(job.path, job.kind, how);
  if (!note.empty()) document.notes.push_back(note);
  return document;
}

AssembledPart part_of(const ReadJob& job, const StageLog& log) {
  const bool meets = !job.meeting.crossing.empty() || !job.meeting.touching.empty();
  const CadDocument document = meets ? document_of_model(job, log) : document_of(job, log);
  try {
    return meets ? assemble(document, job.options, job.meeting, log) : assembled(job, document, log).part;
  } catch (const ModelError& error) {
    throw with_id(error, document);
  }
}

std::string do_job(const ReadJob& job, const StageLog& log) {
  try {
    if (job.piece) {
      const CadDocument document = document_of_model(job, log);
      log("making the piece");
      return encode_piece(make_piece(document.shape, *job.piece));
    }
    const AssembledPart part = part_of(job, log);
    log("handing the part over");
    return encode_part(part.numbering, part.parts);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    throw InputError("the part cannot be analysed: " + cause_of(failure));
  }
}

std::string encode_job(const ReadJob& job) {
  ByteWriter out;
  const PieceWish piece = job.piece.value_or(PieceWish{});
  out(job.piece.has_value(), piece.entities, piece.around, piece.format);
  out(job.path.string(), job.kind, job.shape.IsNull() ? std::string() : encode_shape(job.shape),
      job.options.facet_deflection, job.options.sew_tolerance, job.options.cap, job.options.smallest_feature,
      job.options.embed, job.options.fuse, job.options.fuse_tolerance, job.meeting.crossing,
      job.meeting.touching);
  return std::move(out.bytes);
}

/// In a process of its own, whose messages nobody reads. Elsewhere the printers of OCCT's messenger are the
/// host's, which may be sending messages in other threads.
std::string do_job_silently(const ReadJob& job, const StageLog& log) {
  const Silence silence;
  return do_job(job, log);
}

fs::path directory_of_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

/// The helper where it may be: asked for, in the package that the host was built with, in a build tree, in
/// the tree of an installed program, where it was to be installed, where Debian's package has it. Empty:
/// nowhere.
fs::path find_helper(const ReadJob& job) {
  if (!job.options.reader_program.empty()) return job.options.reader_program;
  const fs::path here = directory_of_program();
  for (const fs::path& path :
       {job.installed_reader, here / "octet-reader", here / "../libexec/octet/octet-reader",
        fs::path(OCTET_READER), fs::path("/usr/libexec/octet/octet-reader")})
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
  if (!options.isolate) {
    if (options.require_isolation) throw InputError("isolation is required, and turned off");
    return in_this_process();
  }
  const ChildLimits limits{options.time_limit,
                           options.memory_limit > 0 ? options.memory_limit : default_memory()};
  if (has_one_thread() && options.reader_program.empty())
    return run_in_child([&](const StageLog& log) { return do_job_silently(job, log); }, limits);
  const fs::path helper = find_helper(job);
  if (!helper.empty()) return run_in_helper(helper, reader_version(), encode_job(job), limits);
  if (options.require_isolation)
    throw InputError(
        "the part cannot be read in a process of its own: this one has several threads, and the program "
        "octet-reader was not found (ReadOptions::reader_program)");
  note = "read without limits of time and memory: the program octet-reader was not found";
  return in_this_process();
}

/// The first face that lies far off its own facets for what was taken away at its borders, by its number as
/// read, and how far; empty: none.
std::string spoilt_face(const Model& model, const ReadOptions& options) {
  constexpr double kFar = 5.0;
  const double kept_to =
      options.facet_deflection > 0.0 ? options.facet_deflection : kDeflectionShare * model.diagonal();
  for (int face = 1; face <= model.count(2); ++face) {
    const double off = model.facets().deviation[static_cast<std::size_t>(face)];
    if (off <= kFar * std::max(options.smallest_feature, kept_to)) continue;
    const auto numbers = sources(model.provenance(), 2, model.count(2))[static_cast<std::size_t>(face)];
    return fmt::format("{} would lie {:.3g} mm off its edges",
                       numbers.empty() ? "a face" : fmt::format("Face {}", numbers.front()), off);
  }
  return {};
}

/// How many solids are left out where nothing is taken away.
std::size_t faults_without_defeaturing(ReadJob job) {
  job.options.smallest_feature = 0.0;
  return read_job(job).faults.size();
}

/// With less taken away, where all that was asked for would spoil the part; `note` says so. The job is left
/// with what was taken.
Model read_defeatured(ReadJob& job, std::string& note) {
  constexpr int kHalvings = 3;
  double& smallest = job.options.smallest_feature;
  const double asked = smallest;
  const TimeLeft time(job.options.time_limit);
  std::string first_cause;
  std::optional<std::size_t> known_faults;
  for (int tries = 0; smallest > 0.0; ++tries) {
    std::string cause;
    try {
      Model model(read_job(job));
      const std::vector<Fault>& faults = model.parts().faults;
      if (!faults.empty() && !known_faults) known_faults = faults_without_defeaturing(job);
      cause =
          faults.size() > known_faults.value_or(0) ? faults.back().cause : spoilt_face(model, job.options);
      if (cause.empty()) return model;
    } catch (const ModelError& error) {
      cause = error.what();
    }
    if (tries == 0) first_cause = cause;
    smallest = tries < kHalvings ? 0.5 * smallest : 0.0;
    note = fmt::format(
        "features smaller than {:.4g} mm cannot all be taken away, for {}: {}", asked, first_cause,
        smallest > 0.0 ? fmt::format("those smaller than {:.4g} mm were", smallest) : "none were");
    job.options.time_limit = time.seconds();
  }
  return Model(read_job(job));
}

}  // namespace

std::string reader_version() { return "Octet " OCTET_VERSION " with OCCT " OCC_VERSION_COMPLETE; }

std::string serve_job(std::string_view request, const StageLog& log) {
  ByteReader in(request);
  ReadJob job;
  std::string path, shape;
  bool has_piece = false;
  PieceWish piece;
  in(has_piece, piece.entities, piece.around, piece.format);
  if (has_piece) job.piece = piece;
  in(path, job.kind, shape, job.options.facet_deflection, job.options.sew_tolerance, job.options.cap,
     job.options.smallest_feature, job.options.embed, job.options.fuse, job.options.fuse_tolerance,
     job.meeting.crossing, job.meeting.touching);
  job.path = path;
  if (!shape.empty()) job.shape = decode_shape(shape);
  return do_job_silently(job, log);
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
    throw Bug("a part that was read cannot be restored: " + cause_of(failure));
  }
}

namespace {

Model read_as_asked(ReadJob job) {
  const TimeLeft time(job.options.time_limit);
  std::string note;
  Model model = read_defeatured(job, note);
  const double for_repair = time.seconds_for_repair();
  job.options.time_limit = for_repair;
  model = read_united(job, std::move(model));
  job.options.time_limit = std::min(for_repair, time.seconds());
  model = read_imprinted(std::move(job), std::move(model));
  return note.empty() ? std::move(model) : with_note(model, note);
}

}  // namespace

PartPiece read_piece(const ReadJob& job) {
  std::string note;  // of limits that there were not: a model's, and a piece has none
  return decode_piece(guarded_bytes(job, note));
}

Model read_model(const ReadJob& job) { return read_at_least_apart(job, read_as_asked); }

}  // namespace octet
