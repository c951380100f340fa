// SPDX-License-Identifier: BSD-3-Clause
// Meshes an analytic box and an OCCT shape through the installed library.
#include <app/mesh_part.h>
#include <geom/analytic.h>
#include <geom/occt/from_shape.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <atomic>
#include <cstdio>
#include <string>
#include <thread>

namespace {

bool mesh(const char* name, const octet::Model& model, double size) {
  octet::MeshOptions options;
  options.size = size;
  const octet::MeshResult result = octet::mesh_part(model, options);
  const bool complete = result.report.status == octet::MeshStatus::kComplete;
  std::printf("%s: %zu tetrahedra, %zu nodes, %s\n", name, result.report.tets, result.report.nodes,
              complete ? "complete" : "incomplete");
  return complete && result.report.tets > 0;
}

/// Errors arrive as the library's own types.
bool refuses_bad_size() {
  try {
    octet::MeshOptions options;
    options.size = -1.0;
    static_cast<void>(octet::mesh_part(octet::analytic_box(octet::Vec3(1, 1, 1)), options));
  } catch (const octet::InputError& error) {
    std::printf("refused: %s\n", error.what());
    return true;
  }
  return false;
}

/// A run ends when its observer asks for it.
bool can_be_cancelled() {
  struct Impatient : octet::Observer {
    [[nodiscard]] bool cancelled() const override { return true; }
  } observer;
  try {
    static_cast<void>(octet::mesh_part(octet::analytic_box(octet::Vec3(1, 1, 1)), {}, observer));
  } catch (const octet::Cancelled&) {
    std::printf("cancelled\n");
    return true;
  }
  return false;
}

/// In a program with several threads a part is read by the installed program octet-reader, which lies where
/// nobody told.
bool reads_isolated_with_threads() {
  std::atomic<bool> done{false};
  std::thread other([&done] { done.wait(false); });
  bool isolated = false;
  try {
    octet::ReadOptions options;
    options.require_isolation = true;
    const octet::Model model = octet::model_from_shape(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape(), options);
    isolated = model.notes().empty();
    for (const std::string& note : model.notes()) std::printf("note: %s\n", note.c_str());
  } catch (const octet::InputError& error) {
    std::printf("not isolated: %s\n", error.what());
  }
  done = true;
  done.notify_all();
  other.join();
  return isolated;
}

}  // namespace

int main() {
  const bool box = mesh("analytic box", octet::analytic_box(octet::Vec3(1, 2, 3)), 0.4);
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
  const bool cylinder = mesh("shape", octet::model_from_shape(shape), 0.4);
  return box && cylinder && refuses_bad_size() && can_be_cancelled() && reads_isolated_with_threads() ? 0 : 1;
}
