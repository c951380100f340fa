// SPDX-License-Identifier: BSD-3-Clause
// What comes out of the reader's repairs against what went in, face by face.
#include "geom/occt/loop_sides.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressRange.hxx>
#include <Precision.hxx>
#include <Resource_Manager.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeProcess_ShapeContext.hxx>
#include <Standard_Version.hxx>
#include <TCollection_AsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Sphere.hxx>
#include <limits>
#include <optional>

#include "base/constants.h"
#include "geom/occt/bounded_sweeps.h"
#include "geom/occt/canonical.h"
#include "geom/occt/holed_torus.h"
#include "geom/occt/loose_curves.h"
#include "geom/occt/missing_poles.h"
#include "geom/occt/reader_repairs.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sphere_loops.h"
#include "geom/occt/sub_shapes.h"
#include "geom/occt/unrolled_loops.h"

namespace octet {
namespace {

struct Ball {
  gp_Sphere sphere;
  bool outward;  ///< whether the normal of the FORWARD face points so
};

std::optional<Ball> ball_of(const TopoDS_Face& face) {
  const auto surface = Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(face));
  if (surface.IsNull()) return {};
  return Ball{surface->Sphere(), surface->Sphere().Direct()};
}

/// Whether an edge runs the same way as another that it lies on.
bool runs_along(const TopoDS_Edge& piece, const TopoDS_Edge& whole) {
  const std::vector<Vec3> a = places_along(piece), b = places_along(whole);
  const std::size_t half = a.size() / 2;
  const Vec3 &middle = a[half], on = a[half + 1] - a[half - 1];
  std::size_t nearest = 1;
  for (std::size_t i = 1; i + 1 < b.size(); ++i)
    if ((b[i] - middle).squaredNorm() < (b[nearest] - middle).squaredNorm()) nearest = i;
  return on.dot(b[nearest + 1] - b[nearest - 1]) > 0.0;
}

std::optional<gp_Torus> torus_of(const TopoDS_Face& face) {
  const auto surface = Handle(Geom_ToroidalSurface)::DownCast(BRep_Tool::Surface(face));
  if (surface.IsNull()) return {};
  return surface->Torus();
}

bool has_curve(const TopoDS_Edge& edge) {
  double first = 0.0, last = 0.0;
  return !BRep_Tool::Degenerated(edge) && !BRep_Tool::Curve(edge, first, last).IsNull();
}

using Images = TopTools_DataMapOfShapeShape;

/// What the reader made of an edge, turned as the edge is: itself, another, some in its place, or nothing.
std::vector<TopoDS_Edge> made_of(const TopoDS_Edge& edge, const Images& images) {
  if (!images.IsBound(edge)) return {edge};
  std::vector<TopoDS_Edge> made;
  const TopoDS_Shape& image = images.Find(edge);
  if (image.IsNull()) return made;
  for (TopExp_Explorer it(image, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge piece = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
    if (has_curve(piece)) made.push_back(runs_along(piece, edge) ? piece : TopoDS::Edge(piece.Reversed()));
  }
  return made;
}

/// Edges of a FORWARD face that it has on one side alone: no seams, no poles.
std::vector<TopoDS_Edge> border_of(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> border;
  std::vector<int> uses;
  const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
  uses.assign(static_cast<std::size_t>(edges.Extent()) + 1, 0);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    ++uses[static_cast<std::size_t>(edges.FindIndex(it.Current()))];
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (uses[static_cast<std::size_t>(edges.FindIndex(edge))] == 1 && !BRep_Tool::Degenerated(edge))
      border.push_back(edge);
  }
  return border;
}

/// How far one turns to the right from the way back along `came` to `goes`, about their common end: 0 to one
/// turn.
double right_turn(const SphereSide& came, const SphereSide& goes) {
  const Vec3& out = came.at.back();
  const Vec3 back = came.at[came.at.size() - 2] - out, on = goes.at[1] - out;
  const double left = std::atan2(out.dot(back.cross(on)), back.dot(on));
  return left >= 0.0 ? kTurn - left : -left;
}

/// The edges as closed chains, each with what lies to its left; empty where they are none.
std::vector<SphereLoop> chained(std::vector<SphereSide> sides) {
  std::vector<SphereLoop> loops;
  while (!sides.empty()) {
    SphereLoop loop{sides.back()};
    sides.pop_back();
    const TopoDS_Vertex start = TopExp::FirstVertex(loop.front().edge, true);
    for (;;) {
      const TopoDS_Vertex end = TopExp::LastVertex(loop.back().edge, true);
      // Where loops touch, the part to the left ends at the first side that one meets turning through it.
      auto next = sides.end();
      double least = end.IsSame(start) ? right_turn(loop.back(), loop.front()) : 2.0 * kTurn;
      for (auto side = sides.begin(); side != sides.end(); ++side) {
        if (!TopExp::FirstVertex(side->edge, true).IsSame(end)) continue;
        const double angle = right_turn(loop.back(), *side);
        if (angle >= least) continue;
        least = angle;
        next = side;
      }
      if (next == sides.end()) {
        if (!end.IsSame(start)) return {};
        break;
      }
      loop.push_back(*next);
      sides.erase(next);
    }
    loops.push_back(loop);
  }
  return loops;
}

/// The edges of a face's border, in those that `images` has for them, with the face to the left seen from
/// where its normal points, or from the other side.
std::vector<TopoDS_Edge> border_in(const TopoDS_Face& raw, bool outward, const Images& images) {
  std::vector<TopoDS_Edge> border;
  for (const TopoDS_Edge& edge : border_of(raw)) {
    if (edge.Orientation() > TopAbs_REVERSED || !has_curve(edge)) return {};
    const std::vector<TopoDS_Edge> made = made_of(outward ? edge : TopoDS::Edge(edge.Reversed()), images);
    border.insert(border.end(), made.begin(), made.end());
  }
  return border;
}

/// What the file says bounds a face, in the edges that `images` has for its own, with the face to the left
/// seen from outside; empty where that cannot be told.
std::vector<SphereLoop> loops_in_file(const TopoDS_Face& raw, const Ball& ball, const Images& images) {
  std::vector<SphereSide> sides;
  const Vec3 centre = to_vec(ball.sphere.Location());
  for (const TopoDS_Edge& edge : border_in(raw, ball.outward, images)) {
    sides.push_back({edge, places_along(edge)});
    for (Vec3& at : sides.back().at) at = (at - centre).normalized();
  }
  return chained(std::move(sides));
}

bool has_seam_or_pole(const TopoDS_Face& face) {
  return border_of(face).size() != static_cast<std::size_t>(sub_shapes(face, TopAbs_EDGE).Extent());
}

enum class Way { kAlike, kAgainst, kUnknown };

/// How what was made of a face's border runs, beside the border itself.
Way way_of(const TopoDS_Face& raw, const TopoDS_Face& read, const Images& images) {
  const std::vector<TopoDS_Edge> now = border_of(read);
  int alike = 0, against = 0;
  for (const TopoDS_Edge& edge : border_of(raw)) {
    if (!has_curve(edge)) continue;
    for (const TopoDS_Edge& image : made_of(edge, images)) {
      const auto same = std::find_if(now.begin(), now.end(),
                                     [&](const TopoDS_Edge& candidate) { return candidate.IsSame(image); });
      if (same != now.end()) ++(same->Orientation() == image.Orientation() ? alike : against);
    }
  }
  if ((alike > 0) == (against > 0)) return Way::kUnknown;
  return alike > 0 ? Way::kAlike : Way::kAgainst;
}

/// Whether the border of what was made of a face runs the other way.
bool is_turned(const TopoDS_Face& raw, const TopoDS_Shape& read, const Images& images) {
  return read.ShapeType() == TopAbs_FACE &&
         way_of(raw, TopoDS::Face(read.Oriented(TopAbs_FORWARD)), images) == Way::kAgainst;
}

/// Whether the curves of a face in (u,v) take more than a turn, so that some are a turn off.
bool is_spread(const TopoDS_Face& face) {
  constexpr int kSamples = 8;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double a = 0.0, b = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, a, b);
    for (int i = 0; !curve.IsNull() && i <= kSamples; ++i) {
      const double u = curve->Value(a + (b - a) * i / kSamples).X();
      least = std::min(least, u);
      most = std::max(most, u);
    }
  }
  constexpr double kRounding = 1e-3;
  return most - least > kTurn + kRounding;
}

/// A face that the reader gave another part of its surface.
struct Wrong {
  TopoDS_Face raw;  ///< as the file has it, FORWARD
  TopoDS_Shape read;
  Ball ball;
};

/// Whether what the reader made of a face on a sphere is not what its loops bound.
bool is_wrong(const Wrong& face, const Images& images) {
  constexpr double kShare = 0.02, kLeast = 1e-3;  // of the smaller side; steradian
  bool closed = has_seam_or_pole(face.raw), turned = false;
  if (face.read.ShapeType() == TopAbs_FACE) {
    const TopoDS_Face read = TopoDS::Face(face.read.Oriented(TopAbs_FORWARD));
    closed = closed || has_seam_or_pole(read);
    turned = is_turned(face.raw, read, images) || is_spread(read);
  }
  if (!closed && !turned) return false;
  const double told = area_between(loops_in_file(face.raw, face.ball, {})), whole = 2.0 * kTurn;
  if (told <= 0.0 || told >= whole) return false;
  const double is = area_of(face.read) / (face.ball.sphere.Radius() * face.ball.sphere.Radius());
  return turned || std::abs(is - told) > kShare * std::min(told, whole - told) + kLeast;
}

/// The sphere in a frame.
Unrolling unrolling_of(const Ball& ball, const SphereFrame& frame) {
  const gp_Pnt centre = ball.sphere.Location();
  const gp_Ax3 axes(centre, gp_Dir(frame.up.x(), frame.up.y(), frame.up.z()),
                    gp_Dir(frame.across.x(), frame.across.y(), frame.across.z()));
  return {new Geom_SphericalSurface(axes, ball.sphere.Radius()), [centre, frame](const gp_Pnt& p) {
            const Vec3 d = to_vec(gp_Vec(centre, p)).normalized(), y = frame.up.cross(frame.across);
            return gp_Pnt2d(std::atan2(d.dot(y), d.dot(frame.across)),
                            std::asin(std::clamp(d.dot(frame.up), -1.0, 1.0)));
          }};
}

/// The loop's edges from a side on.
std::vector<TopoDS_Edge> edges_from(const SphereLoop& loop, std::size_t start) {
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back(loop[(start + i) % loop.size()].edge);
  return edges;
}

/// The part of the sphere that the loops bound, its normal outward; null where there are none, or no frame is
/// clear of them. Standard_Failure where a curve cannot be interpolated.
TopoDS_Face bounded(const Ball& ball, const std::vector<SphereLoop>& loops) {
  const std::optional<SphereFrame> frame = clear_frame(loops);
  if (loops.empty() || !frame) return {};
  const double tolerance = Precision::Confusion();
  constexpr double kQuarter = 0.25 * kTurn;
  const Unrolling on = unrolling_of(ball, *frame);
  const BRep_Builder builder;
  TopoDS_Face made;
  if (frame->ring < 0) {
    made = BRepBuilderAPI_MakeFace(on.surface, 0.0, kTurn, -kQuarter, kQuarter, tolerance).Face();
  } else {
    builder.MakeFace(made, on.surface, tolerance);
    builder.Add(made,
                unrolled_wire(on, edges_from(loops[static_cast<std::size_t>(frame->ring)], frame->start),
                              gp_Pnt2d(kTurn, 0.0)));
    made = carried_to_pole(made, -kQuarter);
    if (made.IsNull()) return {};
  }
  for (std::size_t j = 0; j < loops.size(); ++j)
    if (static_cast<int>(j) != frame->ring)
      builder.Add(made, unrolled_wire(on, edges_from(loops[j], 0), gp_Pnt2d(0.5 * kTurn, 0.0)));
  for (const TopoDS_Edge& edge : border_of(made)) fit_curve(edge, made);
  return made;
}

/// The face that the file has, in the reader's edges, its normal outward; null where it cannot be made.
TopoDS_Face made_anew(const TopoDS_Face& raw, const std::optional<Ball>& ball,
                      const std::optional<gp_Torus>& torus, const Images& images) {
  try {
    return ball ? bounded(*ball, loops_in_file(raw, *ball, images))
                : holed_torus(*torus, border_in(raw, torus->Direct(), images));
  } catch (const Standard_Failure&) {
    return {};
  }
}

using FacesOfEdges = TopTools_IndexedDataMapOfShapeListOfShape;

/// Whether each edge of the face's border has another face on its other side.
bool agrees(const TopoDS_Face& raw, const FacesOfEdges& faces_of) {
  const auto way_along = [](const TopoDS_Shape& face, const TopoDS_Edge& edge) {
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      if (it.Current().IsSame(edge)) return it.Current().Orientation();
    return TopAbs_EXTERNAL;
  };
  for (const TopoDS_Edge& edge : border_of(raw)) {
    if (!faces_of.Contains(edge)) return false;
    TopAbs_Orientation own = TopAbs_EXTERNAL;
    bool beyond = false;
    for (const TopoDS_Shape& face : faces_of.FindFromKey(edge))
      if (face.IsSame(raw)) own = way_along(face, edge);
    for (const TopoDS_Shape& face : faces_of.FindFromKey(edge))
      beyond = beyond || (!face.IsSame(raw) && way_along(face, edge) == TopAbs::Reverse(own));
    if (own > TopAbs_REVERSED || !beyond) return false;
  }
  return true;
}

/// A face of its own with the same surface and loops.
TopoDS_Face copy_of(const TopoDS_Face& face) {
  const BRep_Builder builder;
  TopoDS_Face copy = TopoDS::Face(face.EmptyCopied());
  for (TopoDS_Iterator it(face); it.More(); it.Next()) builder.Add(copy, it.Value());
  return copy;
}

}  // namespace

struct KeepLoopSides::Hook : public XSAlgo_AlgoContainer {
  mutable std::vector<TopoDS_Shape> made, left;

#if OCC_VERSION_HEX >= 0x070700
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real precision,
                            const Standard_Real most_tolerance, const Standard_CString resource,
                            const Standard_CString sequence, Handle(Standard_Transient) & info,
                            const Message_ProgressRange& progress, const Standard_Boolean non_manifold,
                            const TopAbs_ShapeEnum detail) const override {
    bound_swept_hyperbolas(shape);
    if (const auto context = context_of(shape, resource, sequence, info, non_manifold, detail)) {
      info = context;
      repair_but_for_crossings(shape, precision, most_tolerance, *context, progress);
      return mended(shape, context->Result(), info);
    }
    return mended(shape,
                  XSAlgo_AlgoContainer::ProcessShape(shape, precision, most_tolerance, resource, sequence,
                                                     info, progress, non_manifold, detail),
                  info);
  }
#else
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real precision,
                            const Standard_Real most_tolerance, const Standard_CString resource,
                            const Standard_CString sequence, Handle(Standard_Transient) & info,
                            const Message_ProgressRange& progress,
                            const Standard_Boolean non_manifold) const override {
    bound_swept_hyperbolas(shape);
    if (const auto context = context_of(shape, resource, sequence, info, non_manifold, TopAbs_EDGE)) {
      info = context;
      repair_but_for_crossings(shape, precision, most_tolerance, *context, progress);
      return mended(shape, context->Result(), info);
    }
    return mended(shape,
                  XSAlgo_AlgoContainer::ProcessShape(shape, precision, most_tolerance, resource, sequence,
                                                     info, progress, non_manifold),
                  info);
  }
#endif

  /// For a shape with countless sides, where nothing asks for other repairs than the reader's own; else null.
  static Handle(ShapeProcess_ShapeContext)
      context_of(const TopoDS_Shape& shape, Standard_CString resource, Standard_CString sequence,
                 const Handle(Standard_Transient) & info, bool non_manifold, TopAbs_ShapeEnum detail) {
    if (shape.IsNull() || !info.IsNull() || !has_countless_sides(shape)) return {};
    const auto value = [](Standard_CString name) {
      const Standard_CString set = Interface_Static::CVal(name);
      return set != nullptr ? set : name;
    };
    Handle(ShapeProcess_ShapeContext) context = new ShapeProcess_ShapeContext(shape, value(resource));
    if (context->ResourceManager()->Find((TCollection_AsciiString(value(sequence)) + ".exec.op").ToCString()))
      return {};
    context->SetDetalisation(detail);
    context->SetNonManifold(non_manifold);
    return context;
  }

  /// What was read of a shape, with faces on spheres as the shape has them.
  TopoDS_Shape mended(const TopoDS_Shape& shape, const TopoDS_Shape& read,
                      const Handle(Standard_Transient) & info) const {
    const auto context = Handle(ShapeProcess_ShapeContext)::DownCast(info);
    if (context.IsNull() || read.IsNull()) return read;
    const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
    if (!restore(shape, read, context->Map(), *changes)) return read;
    const TopoDS_Shape result = changes->Apply(read);
    context->RecordModification(changes);
    context->SetResult(result);
    return result;
  }

  /// Whether there is anything to change in what was read.
  bool restore(const TopoDS_Shape& shape, const TopoDS_Shape& read, const Images& images,
               ShapeBuild_ReShape& changes) const {
    const TopTools_IndexedMapOfShape raw_faces = sub_shapes(shape, TopAbs_FACE);
    const TopTools_IndexedMapOfShape read_faces = sub_shapes(read, TopAbs_FACE);
    FacesOfEdges faces_of;
    TopTools_MapOfShape done;
    for (int f = 1; f <= raw_faces.Extent(); ++f) {
      const TopoDS_Face raw = TopoDS::Face(raw_faces(f).Oriented(TopAbs_FORWARD));
      const std::optional<Ball> ball = ball_of(raw);
      const std::optional<gp_Torus> torus = torus_of(raw);
      const TopoDS_Shape now = images.IsBound(raw) ? images.Find(raw) : raw;
      if ((!ball && !torus) || now.IsNull() || !raw.Location().IsIdentity()) continue;
      if (ball ? !is_wrong({raw, now, *ball}, images) : !is_turned(raw, now, images)) continue;
      if (faces_of.IsEmpty()) TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
      if (!agrees(raw, faces_of)) continue;
      const int place = now.ShapeType() == TopAbs_FACE ? read_faces.FindIndex(now) : 0;
      const TopoDS_Face right = place > 0 ? made_anew(raw, ball, torus, images) : TopoDS_Face();
      if (right.IsNull()) {
        left.push_back(now);
        continue;
      }
      made.push_back(right);
      const bool direct = ball ? ball->outward : torus->Direct();
      const bool outward = (raw_faces(f).Orientation() == TopAbs_FORWARD) == direct;
      const bool as_read = (read_faces(place).Orientation() == TopAbs_FORWARD) == outward;
      changes.Replace(now.Oriented(TopAbs_FORWARD),
                      right.Oriented(as_read ? TopAbs_FORWARD : TopAbs_REVERSED));
      done.Add(raw);
    }
    if (done.IsEmpty()) return false;
    // The reader may have turned others to agree with those.
    for (int f = 1; f <= raw_faces.Extent(); ++f) {
      const TopoDS_Face raw = TopoDS::Face(raw_faces(f));
      const TopoDS_Shape now = images.IsBound(raw) ? images.Find(raw) : raw;
      if (done.Contains(raw) || now.IsNull() || now.ShapeType() != TopAbs_FACE) continue;
      const int place = read_faces.FindIndex(now);
      if (place == 0 || way_of(raw, TopoDS::Face(read_faces(place)), images) != Way::kAgainst ||
          !agrees(TopoDS::Face(raw.Oriented(TopAbs_FORWARD)), faces_of))
        continue;
      const TopoDS_Face forward = TopoDS::Face(now.Oriented(TopAbs_FORWARD));
      changes.Replace(forward, copy_of(forward).Reversed());
    }
    return true;
  }
};

KeepLoopSides::KeepLoopSides() : hook_(new Hook), before_(XSAlgo::AlgoContainer()) {
  XSAlgo::SetAlgoContainer(hook_);
}

KeepLoopSides::~KeepLoopSides() { XSAlgo::SetAlgoContainer(Handle(XSAlgo_AlgoContainer)::DownCast(before_)); }

const std::vector<TopoDS_Shape>& KeepLoopSides::made() const { return hook_->made; }
const std::vector<TopoDS_Shape>& KeepLoopSides::left() const { return hook_->left; }

}  // namespace octet
