// SPDX-License-Identifier: BSD-3-Clause
// Writes a part turned at random about its middle as OCCT BREP: octet_turn_part FILE OUTPUT.brep SEED.
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <gp_Quaternion.hxx>
#include <random>

#include "geom/occt/document.h"

namespace {

/// A rotation drawn evenly from all rotations: a random unit quaternion [Shoemake 1992].
gp_Quaternion random_rotation(unsigned seed) {
  std::mt19937 draw(seed);
  const auto share = [&] { return static_cast<double>(draw()) / 4294967296.0; };
  const double turn = 2.0 * M_PI, u = share(), v = turn * share(), w = turn * share();
  const double a = std::sqrt(1.0 - u), b = std::sqrt(u);
  return {a * std::sin(v), a * std::cos(v), b * std::sin(w), b * std::cos(w)};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: octet_turn_part FILE OUTPUT.brep SEED\n");
    return 2;
  }
  Message::DefaultMessenger()->ChangePrinters().Clear();
  try {
    const TopoDS_Shape part = octet::read_document(argv[1], octet::file_kind(argv[1])).shape;
    Bnd_Box box;
    BRepBndLib::Add(part, box);
    const gp_XYZ middle = 0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ());
    gp_Trsf to_origin, turn, back;
    to_origin.SetTranslation(gp_Vec(middle.Reversed()));
    turn.SetRotation(random_rotation(static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10))));
    back.SetTranslation(gp_Vec(middle));
    const TopoDS_Shape turned = part.Moved(back * turn * to_origin);
    return BRepTools::Write(turned, argv[2]) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "octet_turn_part: %s\n", error.what());
    return 1;
  }
}
