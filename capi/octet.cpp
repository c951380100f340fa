// SPDX-License-Identifier: BSD-3-Clause
// Arrays as C wants them, and no exception beyond this file.
#include "capi/octet.h"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "app/at_place.h"
#include "app/entity_shapes.h"
#include "app/exit_code.h"
#include "app/failure.h"
#include "app/info_json.h"
#include "app/mesh_request.h"
#include "app/mesh_words.h"
#include "app/part_info.h"
#include "app/report_json.h"
#include "app/summary.h"
#include "base/error.h"
#include "geom/occt/read_part.h"
#include "io/msh_entities.h"
#include "io/write.h"

static_assert(int{OCTET_COMPLETE} == octet::kExitComplete && int{OCTET_BAD_INPUT} == octet::kExitBadInput &&
              int{OCTET_INCOMPLETE} == octet::kExitIncomplete && int{OCTET_FAILED} == octet::kExitFailed);

/// A mesh in arrays.
struct octet_mesh {
  struct Elements {
    int nodes = 0;  ///< of one
    std::vector<std::uint32_t> connectivity;
    std::vector<std::int32_t> tags;
  };

  octet::MadeMesh made;
  double scale = 1.0;  ///< of coordinates: millimetre to the unit asked for
  std::vector<double> coordinates;
  std::vector<std::int32_t> node_entities;
  std::array<Elements, 4> elements;  ///< by dimension; [0] unused
  std::vector<std::string> faults;
  std::string report;
};

namespace {

using namespace octet;
namespace fs = std::filesystem;

thread_local std::string last_error;

/// What `run` returns; for an exception its text is kept, and the code of its kind returned.
template <class Run>
int guarded(const Run& run) {
  try {
    return run();
  } catch (...) {
    Failure failure = failure_of(std::current_exception());
    last_error = std::move(failure.text);
    return failure.code;
  }
}

/// The caller's function, called from its own thread alone.
class Follower : public Observer {
 public:
  Follower(octet_progress progress, void* user) : progress_(progress), user_(user) {}
  void stage(std::string_view name, double fraction) override {
    fraction_ = fraction;
    ask(std::string(name).c_str());
  }
  [[nodiscard]] bool cancelled() const override {
    if (progress_ != nullptr && !ended_ && std::this_thread::get_id() == thread_) ask(nullptr);
    return ended_;
  }

 private:
  void ask(const char* stage) const {
    if (progress_ != nullptr && !ended_ && progress_(stage, fraction_, user_) != 0) ended_ = true;
  }

  octet_progress progress_;
  void* user_;
  double fraction_ = 0.0;
  std::thread::id thread_ = std::this_thread::get_id();
  mutable std::atomic<bool> ended_{false};
};

/// octet-reader beside this library: of an installation, wherever it was put, or of a build; else where
/// ReadOptions looks for it.
fs::path reader_program() {
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&octet_version), &info) == 0 || info.dli_fname == nullptr)
    return {};
  std::error_code error;
  const fs::path folder = fs::canonical(info.dli_fname, error).parent_path();
  if (error) return {};
  for (const char* place :
       {"../libexec/octet/octet-reader", "../../libexec/octet/octet-reader", "../app/octet-reader"})
    if (const fs::path program = folder / place; ::access(program.c_str(), X_OK) == 0) return program;
  return {};
}

std::vector<std::string> words_of(const char* const* words, std::size_t count) {
  if (count > 0 && words == nullptr) throw InputError("there are no words, and their count is not 0");
  std::vector<std::string> all;
  for (std::size_t i = 0; i < count; ++i) {
    if (words[i] == nullptr) throw InputError("word " + std::to_string(i) + " is NULL");
    all.emplace_back(words[i]);
  }
  return all;
}

void fill_arrays(octet_mesh& mesh) {
  const Mesh& from = mesh.made.result.mesh;
  const auto nodes = static_cast<std::uint32_t>(node_count(from));
  for (std::uint32_t node = 0; node < nodes; ++node) {
    for (const double x : node_point(from, node)) mesh.coordinates.push_back(x * mesh.scale);
    const ModelRef on = node_entity(from, node);
    mesh.node_entities.push_back(on.dim);
    mesh.node_entities.push_back(on.tag);
  }
  mesh.elements[1].tags = from.edge_on;
  mesh.elements[2].tags = from.triangle_on;
  mesh.elements[3].tags = from.tet_in;
  const ElementGroups none;  // vertices alone are asked of groups
  for (int dim = 1; dim <= 3; ++dim) {
    octet_mesh::Elements& elements = mesh.elements[static_cast<std::size_t>(dim)];
    for (std::uint32_t i = 0; i < elements.tags.size(); ++i) {
      std::uint64_t own[kMostNodes];
      elements.nodes = element_nodes(from, none, dim, i, own, kVtkTetMid);
      for (int k = 0; k < elements.nodes; ++k)
        elements.connectivity.push_back(static_cast<std::uint32_t>(own[k] - 1));
    }
  }
}

int make(const fs::path& part, const std::string& name, const std::vector<std::string>& words,
         octet_progress progress, void* user, octet_mesh*& made) {
  MeshRequest request = request_of(parse_mesh_wishes(words));
  if (request.reading.reader_program.empty()) request.reading.reader_program = reader_program();
  Follower follower(progress, user);
  auto mesh = std::make_unique<octet_mesh>(octet_mesh{
      make_mesh(part, request, std::nullopt, follower), 1.0 / request.unit.millimetres, {}, {}, {}, {}, {}});
  fill_arrays(*mesh);
  const MeshReport& report = mesh->made.result.report;
  for (const Fault& fault : report.faults) mesh->faults.push_back(fault_line(mesh->made.model, fault));
  mesh->report = mesh_report_json({name, "", request.unit.name}, mesh->made.model, report);
  made = mesh.release();
  return octet_status(made);
}

/// A file that is gone at the end.
class TemporaryFile {
 public:
  TemporaryFile(const void* bytes, std::size_t size) {
    std::string name = (fs::temp_directory_path() / "octet-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) throw OutputError("no file can be made in " + fs::temp_directory_path().string());
    path_ = name;
    const char* from = static_cast<const char*>(bytes);
    while (size > 0) {
      const ssize_t written = ::write(file, from, size);
      if (written <= 0) break;
      from += written;
      size -= static_cast<std::size_t>(written);
    }
    ::close(file);
    if (size > 0) {
      fs::remove(path_);
      throw OutputError("the part cannot be written to " + path_.string() + ": is the disk full?");
    }
  }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Of a dimension that has elements; else one without any.
const octet_mesh::Elements& elements_of(const octet_mesh* mesh, int dimension) {
  static const octet_mesh::Elements kNone;
  return mesh != nullptr && dimension >= 1 && dimension <= 3
             ? mesh->elements[static_cast<std::size_t>(dimension)]
             : kNone;
}

}  // namespace

const char* octet_version(void) { return OCTET_VERSION; }

const char* octet_error(void) { return last_error.c_str(); }

int octet_mesh_file(const char* part, const char* const* words, size_t count, octet_progress progress,
                    void* user, octet_mesh** mesh) {
  if (mesh != nullptr) *mesh = nullptr;
  return guarded([&] {
    if (part == nullptr || mesh == nullptr) throw InputError("the part or the place for its mesh is NULL");
    return make(part, part, words_of(words, count), progress, user, *mesh);
  });
}

int octet_mesh_bytes(const void* part, size_t size, const char* const* words, size_t count,
                     octet_progress progress, void* user, octet_mesh** mesh) {
  if (mesh != nullptr) *mesh = nullptr;
  return guarded([&] {
    if (part == nullptr || mesh == nullptr) throw InputError("the part or the place for its mesh is NULL");
    const TemporaryFile file(part, size);
    return make(file.path(), "", words_of(words, count), progress, user, *mesh);
  });
}

char* octet_info(const char* part, const char* const* words, size_t count) {
  char* text = nullptr;
  guarded([&] {
    if (part == nullptr) throw InputError("the part is NULL");
    ReadOptions reading = parse_reading(words_of(words, count));
    if (reading.reader_program.empty()) reading.reader_program = reader_program();
    const Model model = read_part(part, reading);
    const std::string json = part_info_json(part, model, part_info(model), entity_shapes(model), {});
    text = static_cast<char*>(std::malloc(json.size() + 1));
    if (text == nullptr) throw std::bad_alloc();
    std::memcpy(text, json.c_str(), json.size() + 1);
    return OCTET_COMPLETE;
  });
  return text;
}

void octet_free_text(char* text) { std::free(text); }

int octet_status(const octet_mesh* mesh) {
  return mesh->made.result.report.status == MeshStatus::kComplete ? OCTET_COMPLETE : OCTET_INCOMPLETE;
}

int octet_order(const octet_mesh* mesh) { return mesh->made.result.mesh.mid.empty() ? 1 : 2; }

size_t octet_nodes(const octet_mesh* mesh) { return mesh->node_entities.size() / 2; }
const double* octet_coordinates(const octet_mesh* mesh) { return mesh->coordinates.data(); }
const int32_t* octet_node_entities(const octet_mesh* mesh) { return mesh->node_entities.data(); }

size_t octet_elements(const octet_mesh* mesh, int dimension) {
  return elements_of(mesh, dimension).tags.size();
}
int octet_element_nodes(const octet_mesh* mesh, int dimension) { return elements_of(mesh, dimension).nodes; }
const uint32_t* octet_connectivity(const octet_mesh* mesh, int dimension) {
  return elements_of(mesh, dimension).connectivity.data();
}
const int32_t* octet_element_tags(const octet_mesh* mesh, int dimension) {
  return elements_of(mesh, dimension).tags.data();
}

int octet_entities(const octet_mesh* mesh, int dimension) {
  return dimension < 0 || dimension > 3 ? 0 : mesh->made.model.count(dimension);
}

const char* octet_entity_name(const octet_mesh* mesh, int dimension, int tag) {
  if (tag < 1 || tag > octet_entities(mesh, dimension)) return "";
  // Ascending by tags, of which none is left out.
  return mesh->made.outline.entities[static_cast<std::size_t>(dimension)][static_cast<std::size_t>(tag) - 1]
      .name.c_str();
}

size_t octet_faults(const octet_mesh* mesh) { return mesh->faults.size(); }
const char* octet_fault(const octet_mesh* mesh, size_t number) {
  return number < mesh->faults.size() ? mesh->faults[number].c_str() : nullptr;
}

const char* octet_report(const octet_mesh* mesh) { return mesh->report.c_str(); }

int octet_write(const octet_mesh* mesh, const char* path, const char* format) {
  return guarded([&] {
    if (mesh == nullptr || path == nullptr) throw InputError("the mesh or the path is NULL");
    const MeshFormat as = mesh_format(path, format == nullptr ? "" : format);
    check_format(as, octet_order(mesh));
    WriteOptions options;
    options.scale = mesh->scale;
    write_mesh(path, mesh->made.result.mesh, mesh->made.outline, as, options);
    return OCTET_COMPLETE;
  });
}

void octet_free(octet_mesh* mesh) { delete mesh; }
