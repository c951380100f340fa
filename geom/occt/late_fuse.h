// SPDX-License-Identifier: BSD-3-Clause
// Fuse of one solid with what a fuse of others has made of them.
#pragma once

#include <BRepTools_History.hxx>
#include <BRepTools_ReShape.hxx>
#include <IntTools_Context.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <memory>
#include <vector>

#include "geom/occt/group_fuse.h"

namespace octet {

/// A solid that the others could not be fused with all at once, and what has become of these.
struct LateGroup {
  TopoDS_Shape late;
  std::vector<TopoDS_Shape> near;    ///< solids about it
  std::vector<std::size_t> at_odds;  ///< of which it must have an edge in common with one; none: with any
  std::vector<TopoDS_Shape> others;  ///< solids farther off, which may share faces and edges with those near
  bool splines_join = false;         ///< with what it was at odds with, by themselves, and nothing else does
};

/// Fuses `near` and, last, `late`: as they are, with splines for the surfaces of faces where they come near
/// each other (geom/occt/spline_faces), or with the last as splines all over (geom/occt/spline_solids); up to
/// eight solids with tolerances, too, where nothing but slivers, gaps or something thin is wrong; more than
/// eight not as they are where only splines join it with what it was at odds with.
/// Nothing where none of these is clean, where a solid would not keep its volume, or where the others cannot
/// follow. `noise` (mm): what is thinner lies there by mistake.
[[nodiscard]] std::unique_ptr<GroupFuse> late_fuse(const LateGroup& group, double noise);

/// Solids that took no part in a fuse and share faces, edges or vertices with such as did: they take what
/// became of those, where that is one for one.
class Followers {
 public:
  explicit Followers(const Handle(BRepTools_History) & fuse)
      : fuse_(fuse),
        own_(new BRepTools_History()),
        changes_(new BRepTools_ReShape()),
        context_(new IntTools_Context()) {}

  /// Whether no part of the solid was removed or became several. A solid that is placed cannot follow.
  [[nodiscard]] bool can_follow(const TopoDS_Shape& solid) const;
  /// What the solid becomes; itself where it shares nothing that was changed.
  [[nodiscard]] TopoDS_Shape follow(const TopoDS_Shape& solid);
  /// Of those that follow, and of their own faces and edges.
  [[nodiscard]] const Handle(BRepTools_History) & history() const { return own_; }

 private:
  Handle(BRepTools_History) fuse_, own_;
  Handle(BRepTools_ReShape) changes_;
  Handle(IntTools_Context) context_;
};

}  // namespace octet
