// SPDX-License-Identifier: BSD-3-Clause
// One general fuse of a group of solids, and what is wrong with its result.
#pragma once

#include <BOPAlgo_Builder.hxx>
#include <BRepTools_History.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "geom/occt/near_faces.h"

namespace octet {

/// Something of a fuse that is not as it should be, and the solids to blame: indices in the group, one twice
/// where it is to blame alone.
struct FuseConflict {
  std::array<std::size_t, 2> solids{0, 0};
  Vec3 place = Vec3::Zero();
  std::string cause;
  bool splines_join = false;  ///< two that are joined by themselves, but only as splines
};

/// Of splines, which nothing else joins, edges may end this share of their length from their vertices.
inline constexpr double kTearOfSplines = 0.01;

/// The circles along which faces of different solids touch, no farther than `near` from each other: a general
/// fuse does not find them.
[[nodiscard]] std::vector<TopoDS_Edge> contacts_of(const std::vector<TopoDS_Shape>& solids, double near);

class GroupFuse {
 public:
  /// `contacts` take part in the fuse. `thin`: what two solids fill together, what one of them fills
  /// beside that, what is cut off a face, or what parts their faces, is noise when it is thinner than this.
  /// `tear`: edges may end this share of their length from their vertices. The solids stay as they are, but
  /// that edges of planar faces may get their curves there.
  GroupFuse(const std::vector<TopoDS_Shape>& solids, const std::vector<TopoDS_Edge>& contacts,
            double tolerance, double thin, double tear = 0.0);

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool sound() const { return !failed_ && conflicts_.empty(); }
  /// Sound, and nothing thin, no gaps and no slivers are left.
  [[nodiscard]] bool clean() const {
    return sound() && thin_pieces_ == 0 && slivers_ == 0 && near_.count == 0;
  }
  /// Solids left open, without anything or without a piece of their boundary, two on one side of a face,
  /// faces of others inside of one, pieces of a line along which two touch, faces that another solid cuts in
  /// part only, edges that end elsewhere than their vertices are.
  [[nodiscard]] const std::vector<FuseConflict>& conflicts() const { return conflicts_; }
  /// Those of the group (indices) that were turned into splines before the fuse (geom/occt/spline_solids).
  [[nodiscard]] const std::vector<std::size_t>& as_splines() const { return as_splines_; }
  /// So many of their faces were turned into splines before the fuse (geom/occt/spline_faces).
  [[nodiscard]] int spline_faces() const { return spline_faces_; }
  /// The fuse was not of the group's solids but of what `before` made of them, splines of some, or of some of
  /// their faces.
  void began_with(const Handle(BRepTools_History) & before, std::vector<std::size_t> as_splines,
                  int spline_faces = 0);
  /// Takes these for the conflicts: of solids that are at odds by themselves, too.
  void blame(std::vector<FuseConflict> conflicts) { conflicts_ = std::move(conflicts); }
  /// Thin overlaps, and thin parts of solids that overlap others with the rest.
  [[nodiscard]] int thin_pieces() const { return thin_pieces_; }
  /// Thin pieces of faces that are not thin.
  [[nodiscard]] int slivers() const { return slivers_; }
  /// Faces of two solids, shared by neither, that lie on one another but for noise.
  [[nodiscard]] const NearFaces& near() const { return near_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] const Handle(BRepTools_History) & history() const { return history_; }
  /// What became of each solid of the group; those in two lists are overlaps.
  [[nodiscard]] const std::vector<std::vector<TopoDS_Shape>>& images() const { return images_; }
  /// Whether what became of two of the group has an edge in common.
  [[nodiscard]] bool have_common_edges(std::size_t one, std::size_t other) const;
  /// Whether what became of one of the group has the volume of `solid` to a thousandth of it. Slow.
  [[nodiscard]] bool keeps_volume(std::size_t i, const TopoDS_Shape& solid) const;
  /// What the fuse could not do as it should, in words: where the mesh fails later, this is why.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  [[nodiscard]] std::vector<TopoDS_Shape> images_of(const TopoDS_Shape& solid) const;
  void find_conflicts(const std::vector<TopoDS_Shape>& solids);
  void find_opening(std::size_t solid, const TopoDS_Shape& image);
  void count_thin_pieces(double thin);
  void find_near_faces(double thin);
  void find_pieces(const std::vector<TopoDS_Shape>& solids);
  void find_torn_edges(const std::vector<TopoDS_Shape>& solids, double thin, double tear);
  void judge_face_pieces(const std::vector<TopoDS_Shape>& solids, double thin);

  double tolerance_;
  BOPAlgo_Builder builder_;
  bool failed_ = false;
  Handle(BRepTools_History) history_;
  std::vector<std::vector<TopoDS_Shape>> images_;
  std::vector<FuseConflict> conflicts_;
  int thin_pieces_ = 0, slivers_ = 0;
  std::vector<std::size_t> as_splines_;
  int spline_faces_ = 0;
  NearFaces near_;
};

}  // namespace octet
