// SPDX-License-Identifier: BSD-3-Clause
// Sizes that the user asks for at places of the part: entities by number, name, colour or nearness, and
// shapes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"
#include "geom/model.h"

namespace octet {

/// One wish. Lengths in model units (millimetre).
struct SizeAttribute {
  enum class Where {
    kNumbers,   ///< entities `dim` with tags first..last
    kAsRead,    ///< what the entities `dim` with the numbers first..last of the file have become
    kId,        ///< what the entity `dim` has become that the file itself calls `pattern`: "#4711", "D17"
    kName,      ///< entities whose name matches the pattern; `dim` -1: of any dimension; regions also by the
                ///< names of the parts and assemblies that hold them
    kColour,    ///< faces whose colour matches the pattern
    kNearest,   ///< the entity `dim` nearest to `a`
    kBox,       ///< what lies between the corners a and b
    kBall,      ///< within `radius` of a
    kCylinder,  ///< within `radius` of the axis a..b
  };
  Where where = Where::kNumbers;
  int dim = -1;
  int first = 0, last = 0;
  std::string pattern;  ///< `*` any text, `?` any character
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double radius = 0.0;
  double size = 0.0;  ///< edge length asked for
  int elements = 0;   ///< instead of a size: pieces on each edge (dim 1)
  std::string text;   ///< as the user wrote it, for messages
  double unit = 1.0;  ///< of the lengths in `text`
};

/// From the words of --size-at; `unit` is the length of one of the user's units in model units.
// clang-format off
///
///     Face12=0.5   Edge3-7=0.5   Vertex4=0.1   Region2=3   by number or range, as `octet info` lists them
///     Face%12=0.5   Edge%3-7=0.5                           by number in the file, as CAD systems count
///     Face%#4711=0.5   Edge%D17=0.5                        by what a STEP or IGES file itself calls it
///     Face:bore*=0.5   bore*=0.5   Face:*=1                by name (of faces; of anything; all faces)
///     Face#ff00*=0.5                                       by colour
///     Face@10,0,5=0.5                                      the nearest to a point
///     box:x,y,z,x,y,z=0.5   ball:x,y,z,r=0.5   cylinder:x,y,z,x,y,z,r=0.5
///     Edge5=/12                                            12 elements on the edge
///
/// InputError with the reason when the text means none of these.
// clang-format on
[[nodiscard]] SizeAttribute parse_size_attribute(std::string_view text, double unit = 1.0);

/// The entities that an attribute names, ascending; empty for shapes. InputError when there are none.
[[nodiscard]] std::vector<ModelRef> selected_entities(const Model& model, const SizeAttribute& attribute);

/// Whether it is a piece of space, and names no entities.
[[nodiscard]] bool is_shape(SizeAttribute::Where where);

/// Whether the shape of a box, ball or cylinder attribute meets the box.
[[nodiscard]] bool shape_meets(const SizeAttribute& attribute, const Box3& box);

}  // namespace octet
