// SPDX-License-Identifier: BSD-3-Clause
// One general fuse of a group of solids, and what is wrong with its result.
#include "geom/occt/group_fuse.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Message_Alert.hxx>
#include <Message_Report.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "geom/occt/contact_circle.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/face_pieces.h"
#include "geom/occt/half_cuts.h"
#include "geom/occt/loose_parts.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/torn_edges.h"

namespace octet {
namespace {

const char* meaning_of(std::string_view alert) {
  if (alert == "BOPAlgo_AlertSelfInterferingShape") return "shape(s) that cross themselves";
  if (alert == "BOPAlgo_AlertAcquiredSelfIntersection")
    return "shape(s) that would cross themselves once fused";
  if (alert == "BOPAlgo_AlertIntersectionOfPairOfShapesFailed")
    return "pair(s) that could not be intersected";
  if (alert == "BOPAlgo_AlertTooSmallEdge") return "edge(s) too small to stay";
  if (alert == "BOPAlgo_AlertUnableToOrientTheShell") return "shell(s) without orientation";
  return nullptr;
}

/// What a tolerance that is more than noise should have joined is no farther apart than this many of it.
constexpr double kFartherApart = 4.0;

bool is_inside(TopAbs_Orientation way) { return way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL; }

bool has_inside_faces(const TopoDS_Shape& solid) {
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    if (is_inside(it.Current().Orientation())) return true;
  return false;
}

/// The solids that each face bounds, and on which side.
class FaceSides {
 public:
  void add(std::size_t solid, const TopoDS_Shape& image, bool with_inside) {
    for (TopExp_Explorer it(image, TopAbs_FACE); it.More(); it.Next()) {
      const TopAbs_Orientation way = it.Current().Orientation();
      if (is_inside(way) && !with_inside) continue;
      const auto index = static_cast<std::size_t>(faces_.Add(it.Current()));
      if (index > sides_.size()) sides_.emplace_back();
      sides_[index - 1].push_back({solid, way});
    }
  }

  void find_conflicts(std::vector<FuseConflict>& conflicts) const {
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      const auto& sides = sides_[f];
      const Vec3 place = middle_of(faces_(static_cast<int>(f) + 1));
      for (std::size_t a = 0; a < sides.size(); ++a) {
        if (is_inside(sides[a].way))
          conflicts.push_back({{sides[a].solid, sides[a].solid}, place, "it would hold faces of others"});
        for (std::size_t b = a + 1; b < sides.size(); ++b)
          if (sides[a].way == sides[b].way)
            conflicts.push_back({{sides[a].solid, sides[b].solid},
                                 place,
                                 "both would lie on one side of a face: they overlap by about their "
                                 "tolerances"});
      }
    }
  }

 private:
  struct Side {
    std::size_t solid;
    TopAbs_Orientation way;
  };
  TopTools_IndexedMapOfShape faces_;
  std::vector<std::vector<Side>> sides_;  ///< by index - 1
};

/// The shapes of one type in the images of each solid, with the solids that have them.
class Owners {
 public:
  Owners(const std::vector<std::vector<TopoDS_Shape>>& images, TopAbs_ShapeEnum type) {
    for (std::size_t i = 0; i < images.size(); ++i)
      for (const TopoDS_Shape& image : images[i])
        for (TopExp_Explorer it(image, type); it.More(); it.Next()) {
          const auto index = static_cast<std::size_t>(shapes_.Add(it.Current()));
          if (index > of_.size()) of_.emplace_back();
          if (of_[index - 1].empty() || of_[index - 1].back() != i) of_[index - 1].push_back(i);
        }
  }
  [[nodiscard]] std::size_t size() const { return of_.size(); }
  [[nodiscard]] const TopoDS_Shape& shape(std::size_t k) const { return shapes_(static_cast<int>(k) + 1); }
  [[nodiscard]] const std::vector<std::size_t>& of(std::size_t k) const { return of_[k]; }

 private:
  TopTools_IndexedMapOfShape shapes_;
  std::vector<std::vector<std::size_t>> of_;
};

/// Whether twice the volume over the area, of a plate that is its thickness, is less than `thin`. The area,
/// which takes as long as the volume, is asked for only where a solid of its size may have so much of it.
bool is_thin(const TopoDS_Shape& solid, double thin) {
  constexpr double kMostAreas = 50.0;
  const double volume = 2.0 * std::abs(volume_of(solid)), diagonal = diagonal_of(box_of(solid));
  return volume < thin * kMostAreas * diagonal * diagonal && volume < thin * area_of(solid);
}

/// Planar faces of many edges keep their edges' curves in the plane, which OCCT else finds anew each time
/// that it asks for a face's bounds, once for every pair of faces that come near one another. Nothing is done
/// where they have them.
void keep_curves_on_planes(const TopoDS_Shape& solid) {
  constexpr int kMany = 32;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    if (edges.Extent() < kMany) continue;
    for (int i = 1; i <= edges.Extent(); ++i)
      BRepLib::BuildPCurveForEdgeOnPlane(TopoDS::Edge(edges(i)), face);
  }
}

/// The edges that end at each vertex.
TopTools_IndexedDataMapOfShapeListOfShape edges_of_vertices(const std::vector<TopoDS_Shape>& shapes) {
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  for (const TopoDS_Shape& shape : shapes)
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges);
  return edges;
}

}  // namespace

std::vector<TopoDS_Edge> contacts_of(const std::vector<TopoDS_Shape>& solids, double near) {
  struct Side {
    TopoDS_Face face;
    std::size_t solid;
    Bnd_Box box;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (TopExp_Explorer it(solids[i], TopAbs_FACE); it.More(); it.Next()) {
      sides.push_back({TopoDS::Face(it.Current()), i, box_of(it.Current())});
      sides.back().box.Enlarge(near);
    }
  const auto low = [](const Side& side) { return side.box.CornerMin().X(); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return low(a) < low(b); });
  std::vector<TopoDS_Edge> circles;
  for (auto a = sides.begin(); a != sides.end(); ++a)
    for (auto b = a + 1; b != sides.end() && low(*b) <= a->box.CornerMax().X(); ++b) {
      if (a->solid == b->solid || a->box.IsOut(b->box)) continue;
      const std::vector<TopoDS_Edge> found = contact_circles(a->face, b->face, near);
      circles.insert(circles.end(), found.begin(), found.end());
    }
  return circles;
}

GroupFuse::GroupFuse(const std::vector<TopoDS_Shape>& solids, const std::vector<TopoDS_Edge>& contacts,
                     double tolerance, double thin, double tear)
    : tolerance_(tolerance) {
  for (const TopoDS_Shape& solid : solids) {
    keep_curves_on_planes(solid);
    builder_.AddArgument(solid);
  }
  for (const TopoDS_Edge& circle : contacts) builder_.AddArgument(circle);
  builder_.SetNonDestructive(true);
  builder_.SetRunParallel(false);
  if (tolerance > 0.0) builder_.SetFuzzyValue(tolerance);
  builder_.Perform();
  failed_ = builder_.HasErrors();
  if (failed_) return;
  history_ = builder_.History();
  for (const TopoDS_Shape& solid : solids) images_.push_back(images_of(solid));
  drop_loose_parts(solids, images_, history_);
  find_conflicts(solids);
  count_thin_pieces(thin);
  find_near_faces(tolerance > thin ? kFartherApart * tolerance : thin);
  find_pieces(solids);
  judge_face_pieces(solids, thin);
  find_torn_edges(solids, thin, tear);
  for (const HalfCut& cut : half_cuts(images_))
    conflicts_.push_back({cut.solids, cut.place, "they overlap, and their faces are cut in part only"});
}

void GroupFuse::began_with(const Handle(BRepTools_History) & before, std::vector<std::size_t> as_splines,
                           int spline_faces) {
  as_splines_ = std::move(as_splines);
  spline_faces_ = spline_faces;
  if (failed_) return;
  const Handle(BRepTools_History) all = new BRepTools_History();
  all->Merge(before);
  all->Merge(history_);
  history_ = all;
}

bool GroupFuse::have_common_edges(std::size_t one, std::size_t other) const {
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Shape& image : images_[one]) TopExp::MapShapes(image, TopAbs_EDGE, edges);
  for (const TopoDS_Shape& image : images_[other])
    for (TopExp_Explorer it(image, TopAbs_EDGE); it.More(); it.Next())
      if (edges.Contains(it.Current())) return true;
  return false;
}

bool GroupFuse::keeps_volume(std::size_t i, const TopoDS_Shape& solid) const {
  constexpr double kShare = 1e-3;
  const double before = refined_volume_of(solid);
  double after = 0.0;
  for (const TopoDS_Shape& image : images_[i]) after += refined_volume_of(image);
  return std::abs(after - before) <= kShare * std::abs(before);
}

std::vector<std::string> GroupFuse::warnings() const {
  std::map<std::string, int> counts;
  for (const Handle(Message_Alert) & alert : builder_.GetReport()->GetAlerts(Message_Warning))
    ++counts[alert->GetMessageKey()];
  std::vector<std::string> texts;
  for (const auto& [key, count] : counts) {
    const char* meaning = meaning_of(key);
    texts.push_back(
        fmt::format("general fuse warns of {} {}", count, meaning != nullptr ? meaning : key.c_str()));
  }
  return texts;
}

std::vector<TopoDS_Shape> GroupFuse::images_of(const TopoDS_Shape& solid) const {
  const TopTools_ListOfShape& made = history_->Modified(solid);
  if (made.IsEmpty())
    return history_->IsRemoved(solid) ? std::vector<TopoDS_Shape>() : std::vector<TopoDS_Shape>{solid};
  std::vector<TopoDS_Shape> result;
  for (const TopoDS_Shape& image : made)
    if (image.ShapeType() == TopAbs_SOLID) result.push_back(image);
  return result;
}

void GroupFuse::find_conflicts(const std::vector<TopoDS_Shape>& solids) {
  TopTools_MapOfShape seen;
  FaceSides sides;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const bool was_open = edge_uses(solids[i]).first(&Uses::open) != 0;
    const bool had_inside = has_inside_faces(solids[i]);
    if (images_[i].empty())
      conflicts_.push_back({{i, i}, middle_of(solids[i]), "nothing would be left of it"});
    for (const TopoDS_Shape& image : images_[i]) {
      if (!seen.Add(image)) continue;
      if (!was_open) find_opening(i, image);
      sides.add(i, image, !had_inside);
    }
  }
  sides.find_conflicts(conflicts_);
}

void GroupFuse::count_thin_pieces(double thin) {
  const Owners owners(images_, TopAbs_SOLID);
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const std::vector<std::size_t>& of = owners.of(k);
    const bool is_part =
        std::any_of(of.begin(), of.end(), [&](std::size_t i) { return images_[i].size() > 1; });
    if ((is_part || of.size() > 1) && is_thin(owners.shape(k), thin)) ++thin_pieces_;
  }
}

void GroupFuse::find_near_faces(double thin) {
  const Owners faces(images_, TopAbs_FACE);
  std::vector<FaceOfSolid> unshared;
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (faces.of(k).size() == 1) unshared.push_back({TopoDS::Face(faces.shape(k)), faces.of(k).front()});
  near_ = near_faces(unshared, thin);
}

// Surfaces that touch along a line meet nowhere or in places by rounding: the edges found there end nowhere.
// A closed edge, which may have a vertex to itself, has no ends.
// Of two solids that one is to blame which shares fewer faces.
void GroupFuse::find_pieces(const std::vector<TopoDS_Shape>& solids) {
  std::vector<int> shared(images_.size(), 0);
  const Owners faces(images_, TopAbs_FACE), edges(images_, TopAbs_EDGE);
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (const std::size_t i : faces.of(k)) shared[i] += faces.of(k).size() > 1 ? 1 : 0;
  std::vector<TopoDS_Shape> all;
  for (const auto& own : images_) all.insert(all.end(), own.begin(), own.end());
  const auto before = edges_of_vertices(solids), now = edges_of_vertices(all);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::array<std::size_t, 2> of{edges.of(k).front(), edges.of(k).back()};
    bool ends = false;
    const TopoDS_Edge& edge = TopoDS::Edge(edges.shape(k));
    if (TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge))) continue;
    for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next())
      ends = ends || (now.FindFromKey(it.Current()).Extent() == 1 && !before.Contains(it.Current()));
    if (!ends) continue;
    FuseConflict conflict{of, middle_of(edge), "they touch along a line that is found in pieces"};
    if (shared[of[0]] != shared[of[1]]) conflict.solids.fill(shared[of[0]] < shared[of[1]] ? of[0] : of[1]);
    conflicts_.push_back(conflict);
  }
}

void GroupFuse::judge_face_pieces(const std::vector<TopoDS_Shape>& solids, double thin) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const std::vector<FacePiece> pieces = face_pieces(solids[i], *history_);
    slivers_ += count_slivers(pieces, thin);
    if (images_[i].empty()) continue;
    TopoDS_Face lost = lost_piece(pieces, images_[i]);
    if (lost.IsNull()) lost = lost_face(solids[i], images_[i], *history_, thin);
    if (!lost.IsNull()) conflicts_.push_back({{i, i}, middle_of(lost), "a part of it would be lost"});
  }
}

// The fuse's own vertices may have a tolerance that covers any gap; those of the solids tell what is usual.
void GroupFuse::find_torn_edges(const std::vector<TopoDS_Shape>& solids, double thin, double tear) {
  TopTools_IndexedMapOfShape before;
  std::vector<double> near;
  for (const TopoDS_Shape& solid : solids) {
    TopExp::MapShapes(solid, TopAbs_EDGE, before);
    near.push_back(std::max(thin, 2.0 * (tolerance_ + BRep_Tool::MaxTolerance(solid, TopAbs_VERTEX))));
  }
  const Owners edges(images_, TopAbs_EDGE);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.shape(k));
    const std::size_t first = edges.of(k).front(), last = edges.of(k).back();
    if (before.Contains(edge) || !is_torn(edge, std::max(near[first], near[last]), tear)) continue;
    conflicts_.push_back({{first, last}, middle_of(edge), "an edge would end elsewhere than its vertex is"});
  }
}

void GroupFuse::find_opening(std::size_t solid, const TopoDS_Shape& image) {
  const EdgeUses uses = edge_uses(image);
  if (const int edge = uses.first(&Uses::open); edge != 0)
    conflicts_.push_back({{solid, solid}, middle_of(uses.edges(edge)), "it would not be closed"});
}

}  // namespace octet
