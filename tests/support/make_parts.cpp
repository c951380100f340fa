// SPDX-License-Identifier: BSD-3-Clause
// Writes parts drawn at random, as engineers make them: octet_make_parts DIRECTORY --count N [--seed S]
// [--kind NAME] [--every-format]. Part i of a seed is the same whatever is made besides, by the same compiler
// (others draw the arguments of a call in another order); files are named SEED-INDEX-KIND. Mostly STEP, some
// IGES and BREP, some in inches or metres, some turned or far from the origin. Only what BRepCheck_Analyzer
// calls valid.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <CLI/CLI.hpp>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace {

using namespace octet::test;

constexpr unsigned kSecondsPerPart = 40;  // for what OCCT does not end; such a part is left out

std::vector<PartKind> all_kinds() {
  std::vector<PartKind> all;
  for (const auto& kinds : {milled_kinds(), turned_kinds(), thin_kinds(), free_form_kinds(), joined_kinds()})
    all.insert(all.end(), kinds.begin(), kinds.end());
  return all;
}

/// Half as it was drawn; else turned about the axes by quarters, or at random, some far off.
gp_Trsf placement(Draw& draw) {
  if (draw.chance(0.5)) return {};
  gp_Trsf place;
  const double quarter = std::numbers::pi / 2;
  for (const gp_Dir& axis : {gp::DX(), gp::DZ()}) {
    const double angle = draw.chance(0.3) ? quarter * draw.count(0, 3) : draw.between(0, 4 * quarter);
    place = turn(gp_Ax1(gp_Pnt(), axis), angle) * place;
  }
  if (draw.chance(0.4))
    place = shift(draw.between(-2e3, 2e3), draw.between(-2e3, 2e3), draw.scaled(10, 2e4)) * place;
  return place;
}

bool write_iges(const TopoDS_Shape& part, const std::string& stem, const char* unit) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, 1);  // 1: solids, not loose faces
  writer.AddShape(part);
  writer.ComputeModel();
  return writer.Write((stem + ".iges").c_str());
}

bool write_step(const TopoDS_Shape& part, const std::string& stem, const char* unit) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  return writer.Transfer(part, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write((stem + ".step").c_str()) == IFSelect_RetDone;
}

/// In a format and a unit that are drawn, or in every format.
bool write(const TopoDS_Shape& part, const std::string& stem, Draw& draw, bool every) {
  const double format = draw.share();
  const double unit = draw.share();
  const char* const name = unit < 0.8 ? "MM" : unit < 0.9 ? "INCH" : "M";
  bool written = true;
  if (every || format < 0.1) written = BRepTools::Write(part, (stem + ".brep").c_str());
  if (every || (format >= 0.1 && format < 0.2)) written = write_iges(part, stem, name) && written;
  if (every || format >= 0.2) written = write_step(part, stem, name) && written;
  return written;
}

bool make(const PartKind& kind, std::uint64_t seed, const std::string& stem, bool every) {
  Draw draw(seed);
  try {
    const TopoDS_Shape part = moved(kind.make(draw), placement(draw));
    return is_sound(part) && write(part, stem, draw, every);
  } catch (const Standard_Failure&) {
    return false;
  } catch (const std::exception&) {
    return false;
  }
}

/// In a process of its own: OCCT may hang or crash.
bool make_apart(const PartKind& kind, std::uint64_t seed, const std::string& stem, bool every) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSecondsPerPart);
    std::freopen("/dev/null", "w", stdout);
    _exit(make(kind, seed, stem, every) ? 0 : 1);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<PartKind> kinds = all_kinds();
  std::vector<std::string> names;
  for (const PartKind& kind : kinds) names.push_back(kind.name);

  std::string folder, only;
  int count = 100;
  std::uint64_t seed = 1;
  CLI::App app("Writes parts drawn at random, as engineers make them");
  app.add_option("directory", folder, "where to")->required()->check(CLI::ExistingDirectory);
  app.add_option("--count", count, "how many are tried")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--seed", seed, "others make other parts")->capture_default_str();
  bool every = false;
  app.add_flag("--every-format", every, "each part as BREP, IGES and STEP, not in one that is drawn");
  app.add_option("--kind", only, "those of one kind")->check(CLI::IsMember(names));
  CLI11_PARSE(app, argc, argv);

  Message::DefaultMessenger()->ChangePrinters().Clear();
  int made = 0;
  for (int i = 0; i < count; ++i) {
    const PartKind& kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
    if (!only.empty() && only != kind.name) continue;
    const std::string stem = fmt::format("{}/{}-{:04}-{}", folder, seed, i, kind.name);
    if (make_apart(kind, 1000003 * seed + static_cast<std::uint64_t>(i), stem, every))
      ++made;
    else
      fmt::print("{}: none\n", stem);
    std::fflush(stdout);
  }
  fmt::print("{} parts\n", made);
  return made > 0 ? 0 : 1;
}
