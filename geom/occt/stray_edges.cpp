// SPDX-License-Identifier: BSD-3-Clause
// Points of an edge move to the meeting of the tangent planes of its faces at their feet, until they stay.
#include "geom/occt/stray_edges.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>

#include "geom/occt/canonical.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/surface_foot.h"

namespace octet {
namespace {

/// A new edge is no farther from its faces than this share of the old gap.
constexpr double kBetterEdge = 0.1;
/// So many gaps a point may move: faces that meet at 15 degrees.
constexpr double kFarthestStray = 4.0;
/// Directions that all the planes at a point say less of than this, of what they say of another, are free:
/// across an edge between two faces of one surface, or that are near to tangent.
constexpr double kFree = 0.01;
/// A face that is no wider than so many gaps is a strip, for geom/occt/strips to judge by its sides.
constexpr double kWide = 4.0;
constexpr int kFewestSamples = 16, kMostSamples = 1024;
constexpr int kMostSteps = 40;

/// A surface and where on it a point's foot was last.
struct Footing {
  Handle(Geom_Surface) surface;
  SurfaceBounds bounds;
  Vec2 uv;

  Footing(const TopoDS_Face& face, const gp_Pnt2d& at)
      : surface(BRep_Tool::Surface(face)), uv(at.X(), at.Y()) {
    bounds = bounds_of(*surface);
  }
  [[nodiscard]] Vec3 foot() const { return to_vec(surface->Value(uv[0], uv[1])); }
  void follow(const Vec3& point) { uv = foot_from(*surface, bounds, point, uv); }
  /// Unit; none where the surface has none.
  [[nodiscard]] std::optional<Vec3> normal() const {
    gp_Pnt at;
    gp_Vec du, dv;
    surface->D1(uv[0], uv[1], at, du, dv);
    const Vec3 u = to_vec(du), v = to_vec(dv), n = u.cross(v);
    if (!(n.norm() > 1e-9 * u.norm() * v.norm())) return std::nullopt;
    return n.normalized();
  }
};

/// Largest distance (mm) of an edge from a face's surface, by samples, each from where its curve on the face
/// is.
double surface_gap(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kSamples = 24;
  double t0 = 0.0, t1 = 0.0, s0 = 0.0, s1 = 0.0;
  const auto curve = BRep_Tool::Curve(edge, t0, t1);
  const auto on_face = BRep_Tool::CurveOnSurface(edge, face, s0, s1);
  double gap = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double share = static_cast<double>(i) / kSamples;
    const Vec3 point = to_vec(curve->Value(t0 + share * (t1 - t0)));
    Footing sheet(face, on_face->Value(s0 + share * (s1 - s0)));
    sheet.follow(point);
    gap = std::max(gap, (sheet.foot() - point).norm());
  }
  return gap;
}

/// A curve and the parameter of a point's foot on it.
struct Track {
  Handle(Geom_Curve) curve;
  double t = 0.0;

  [[nodiscard]] Vec3 foot() const { return to_vec(curve->Value(t)); }
  [[nodiscard]] Vec3 tangent() const {
    gp_Pnt at;
    gp_Vec d;
    curve->D1(t, at, d);
    return to_vec(d);
  }
  void follow(const Vec3& point) {
    for (int step = 0; step < kMostSteps; ++step) {
      const Vec3 d = tangent();
      if (!(d.squaredNorm() > 0.0)) return;
      const double move = (point - foot()).dot(d) / d.squaredNorm();
      t += move;
      if (!curve->IsPeriodic()) t = std::clamp(t, curve->FirstParameter(), curve->LastParameter());
      if (std::abs(move) <= 1e-14 * (1.0 + std::abs(t))) return;
    }
  }
};

/// The nearest point to `point` at which all of these meet, with their feet there; none where they do not,
/// within `apart`.
std::optional<Vec3> meet(Vec3 point, std::vector<Footing>& sheets, std::vector<Track>& tracks, double apart) {
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
    Vec3 pull = Vec3::Zero();
    for (Footing& sheet : sheets) {
      sheet.follow(point);
      const std::optional<Vec3> n = sheet.normal();
      if (!n) return std::nullopt;
      planes += *n * n->transpose();
      pull += *n * n->dot(sheet.foot() - point);
    }
    for (Track& track : tracks) {
      track.follow(point);
      const Vec3 along = track.tangent().normalized();
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
      planes += across;
      pull += across * (track.foot() - point);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes);
    Vec3 move = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
      if (axes.eigenvalues()[i] > kFree * axes.eigenvalues()[2])
        move += axes.eigenvectors().col(i) * axes.eigenvectors().col(i).dot(pull) / axes.eigenvalues()[i];
    if (!move.allFinite()) return std::nullopt;
    point += move;
    if (move.norm() <= 1e-6 * apart) break;
  }
  double off = 0.0;
  for (Footing& sheet : sheets) {
    sheet.follow(point);
    off = std::max(off, (sheet.foot() - point).norm());
  }
  for (Track& track : tracks) {
    track.follow(point);
    off = std::max(off, (track.foot() - point).norm());
  }
  if (!(off <= apart)) return std::nullopt;
  return point;
}

struct Stray {
  TopoDS_Edge edge;  ///< forward
  std::array<TopoDS_Face, 2> faces;
  double gap = 0.0;    ///< from them
  double apart = 0.0;  ///< that is allowed
};

struct Drawn {
  Handle(Geom_BSplineCurve) in_space;
  std::array<Handle(Geom2d_BSplineCurve), 2> on_face;
};

/// Where the vertices are to be, by their numbers in the map of vertices.
using Places = std::map<int, Vec3>;

class Drawing {
 public:
  Drawing(const Stray& stray, const Vec3& first, const Vec3& last) : stray_(stray), ends_{first, last} {
    curve_ = BRep_Tool::Curve(stray.edge, t0_, t1_);
    for (std::size_t i = 0; i < 2; ++i)
      on_face_[i] = BRep_Tool::CurveOnSurface(stray.edge, stray.faces[i], s0_[i], s1_[i]);
  }

  /// None where the faces do not meet all along.
  [[nodiscard]] std::optional<Drawn> best() const {
    std::optional<Drawn> best;
    double least = kBetterEdge * stray_.gap;
    for (int pieces = kFewestSamples; pieces <= kMostSamples; pieces *= 2) {
      const std::optional<Drawn> drawn = through(pieces);
      if (!drawn) return std::nullopt;
      const double gap = gap_between(*drawn);
      if (gap < least) {
        least = gap;
        best = drawn;
      }
      if (gap <= 1e-3 * stray_.apart) break;
    }
    return best;
  }

 private:
  [[nodiscard]] std::optional<Drawn> through(int pieces) const {
    const Vec3 off_first = ends_[0] - to_vec(curve_->Value(t0_)),
               off_last = ends_[1] - to_vec(curve_->Value(t1_));
    const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, pieces + 1);
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, pieces + 1);
    std::array<Handle(TColgp_HArray1OfPnt2d), 2> uv;
    for (auto& list : uv) list = new TColgp_HArray1OfPnt2d(1, pieces + 1);
    std::vector<Track> none;
    Vec3 before = Vec3::Zero(), old_before = before;
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces, t = t0_ + share * (t1_ - t0_);
      const Vec3 old = to_vec(curve_->Value(t));
      std::vector<Footing> sheets;
      for (std::size_t k = 0; k < 2; ++k)
        sheets.emplace_back(stray_.faces[k], on_face_[k]->Value(s0_[k] + share * (s1_[k] - s0_[k])));
      const bool is_end = i == 0 || i == pieces;
      std::optional<Vec3> point = i == 0 ? ends_[0] : ends_[1];
      if (is_end)
        for (Footing& sheet : sheets) sheet.follow(*point);
      else
        point = meet(old + (1.0 - share) * off_first + share * off_last, sheets, none, 1e-3 * stray_.apart);
      if (!point || (*point - old).norm() > kFarthestStray * stray_.gap) return std::nullopt;
      if (i > 0 && !((*point - before).dot(old - old_before) > 0.0)) return std::nullopt;  // it turns back
      before = *point;
      old_before = old;
      parameters->SetValue(i + 1, t);
      points->SetValue(i + 1, to_pnt(*point));
      for (std::size_t k = 0; k < 2; ++k) uv[k]->SetValue(i + 1, gp_Pnt2d(sheets[k].uv[0], sheets[k].uv[1]));
    }
    try {
      Drawn drawn;
      GeomAPI_Interpolate fit(points, parameters, false, Precision::Confusion());
      fit.Perform();
      if (!fit.IsDone()) return std::nullopt;
      drawn.in_space = fit.Curve();
      for (std::size_t k = 0; k < 2; ++k) {
        Geom2dAPI_Interpolate fit_on_face(uv[k], parameters, false, Precision::PConfusion());
        fit_on_face.Perform();
        if (!fit_on_face.IsDone()) return std::nullopt;
        drawn.on_face[k] = fit_on_face.Curve();
      }
      return drawn;
    } catch (const Standard_Failure&) {
      return std::nullopt;  // points that coincide: no curve through them
    }
  }

  /// From the faces at equal parameter, between the points that the curves were drawn through.
  [[nodiscard]] double gap_between(const Drawn& drawn) const {
    constexpr int kBetween = 4;
    double gap = 0.0;
    for (int i = 1; i < drawn.in_space->NbKnots(); ++i)
      for (int j = 0; j < kBetween; ++j) {
        const double from = drawn.in_space->Knot(i), to = drawn.in_space->Knot(i + 1);
        const double t = from + (to - from) * j / kBetween;
        const gp_Pnt point = drawn.in_space->Value(t);
        for (std::size_t k = 0; k < 2; ++k) {
          const gp_Pnt2d uv = drawn.on_face[k]->Value(t);
          gap = std::max(gap, BRep_Tool::Surface(stray_.faces[k])->Value(uv.X(), uv.Y()).Distance(point));
        }
      }
    return gap;
  }

  const Stray& stray_;
  std::array<Vec3, 2> ends_;
  double t0_ = 0.0, t1_ = 0.0;
  std::array<double, 2> s0_{}, s1_{};
  Handle(Geom_Curve) curve_;
  std::array<Handle(Geom2d_Curve), 2> on_face_;
};

/// The range of its curve that an edge which is not redrawn is to have.
struct Trimmed {
  TopoDS_Edge edge;
  std::array<double, 2> range{};
};

class Redrawing {
 public:
  explicit Redrawing(const std::vector<TopoDS_Shape>& solids) {
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& solid : solids) builder.Add(all, solid);
    all_ = all;
    for (const TopoDS_Shape& solid : solids) find_in(solid);
  }

  std::vector<EdgeRedrawn> run() {
    try {
      // Each round leaves out what cannot be drawn, for what is beside it depends on it; with none left the
      // plan is empty.
      while (!plan()) {
      }
    } catch (const Standard_Failure&) {
      return {};  // a curve or surface that cannot be evaluated is for later stages to name
    }
    return apply();
  }

 private:
  void find_in(const TopoDS_Shape& solid) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    double apart = 0.0;
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge) || !(BRep_Tool::Tolerance(edge) > Precision::Confusion())) continue;
      if (apart == 0.0) apart = kStrayShare * diagonal_of(vertex_box_of(solid));
      if (!(BRep_Tool::Tolerance(edge) > apart)) continue;
      map_all();
      Stray stray{edge, {}, 0.0, apart};
      if (!has_two_faces(stray)) continue;
      for (const TopoDS_Face& face : stray.faces) stray.gap = std::max(stray.gap, surface_gap(edge, face));
      const auto is_wide = [&](const TopoDS_Face& face) { return width_of(face) > kWide * stray.gap; };
      if (stray.gap > apart && std::all_of(stray.faces.begin(), stray.faces.end(), is_wide))
        strays_.push_back(stray);
    }
  }

  void map_all() {
    if (!faces_at_.IsEmpty()) return;
    TopExp::MapShapesAndUniqueAncestors(all_, TopAbs_EDGE, TopAbs_FACE, faces_at_);
    TopExp::MapShapesAndUniqueAncestors(all_, TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
  }

  [[nodiscard]] bool has_two_faces(Stray& stray) const {
    const TopTools_ListOfShape& faces = faces_at_.FindFromKey(stray.edge);
    if (faces.Extent() != 2) return false;
    stray.faces = {TopoDS::Face(faces.First().Oriented(TopAbs_FORWARD)),
                   TopoDS::Face(faces.Last().Oriented(TopAbs_FORWARD))};
    double first = 0.0, last = 0.0;
    if (BRep_Tool::Curve(stray.edge, first, last).IsNull() || !(last > first)) return false;
    return std::all_of(stray.faces.begin(), stray.faces.end(), [&](const TopoDS_Face& face) {
      return !BRep_Tool::IsClosed(stray.edge, face) &&
             !BRep_Tool::CurveOnSurface(stray.edge, face, first, last).IsNull();
    });
  }

  [[nodiscard]] std::array<int, 2> ends_of(const TopoDS_Edge& edge) const {
    return {edges_at_.FindIndex(TopExp::FirstVertex(edge)), edges_at_.FindIndex(TopExp::LastVertex(edge))};
  }

  [[nodiscard]] bool is_stray(const TopoDS_Edge& edge) const {
    return std::any_of(strays_.begin(), strays_.end(), [&](const Stray& s) { return s.edge.IsSame(edge); });
  }

  /// False when strays had to be left out.
  bool plan() {
    places_.clear();
    trimmed_.clear();
    drawn_.clear();
    std::map<int, std::array<double, 2>> ends;  // gap and what is allowed, by vertex
    for (const Stray& stray : strays_)
      for (const int v : ends_of(stray.edge)) {
        auto& [gap, apart] = ends.try_emplace(v, std::array{0.0, stray.apart}).first->second;
        gap = std::max(gap, stray.gap);
        apart = std::min(apart, stray.apart);
      }
    for (const auto& [v, end] : ends)
      if (v == 0 || !place(v, end[0], end[1])) return leave_out_at(v);
    for (const auto& [v, end] : ends)
      for (const TopoDS_Shape& shape : edges_at_(v))
        if (!is_stray(TopoDS::Edge(shape)) && !trim(TopoDS::Edge(shape), end[1])) return leave_out_at(v);
    for (std::size_t i = 0; i < strays_.size(); ++i) {
      const auto [first, last] = ends_of(strays_[i].edge);
      const std::optional<Drawn> drawn = Drawing(strays_[i], places_.at(first), places_.at(last)).best();
      if (!drawn) {
        strays_.erase(strays_.begin() + static_cast<std::ptrdiff_t>(i));
        return false;
      }
      drawn_.push_back(*drawn);
    }
    return true;
  }

  bool leave_out_at(int v) {
    std::erase_if(strays_, [&](const Stray& stray) {
      const auto [first, last] = ends_of(stray.edge);
      return first == v || last == v;
    });
    return false;
  }

  /// Finds where the faces of all edges at a vertex meet, and the edges that stay.
  bool place(int v, double gap, double apart) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(edges_at_.FindKey(v));
    const Vec3 at = to_vec(BRep_Tool::Pnt(vertex));
    std::vector<Footing> sheets;
    std::vector<Track> tracks;
    for (const TopoDS_Shape& shape : edges_at_(v)) {
      const TopoDS_Edge edge = TopoDS::Edge(shape.Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge)) return false;
      const bool is_first = TopExp::FirstVertex(edge).IsSame(vertex);
      double t0 = 0.0, t1 = 0.0;
      for (const TopoDS_Shape& face : faces_at_.FindFromKey(edge)) {
        const auto curve =
            BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), t0, t1);
        if (curve.IsNull()) return false;
        sheets.emplace_back(TopoDS::Face(face), curve->Value(is_first ? t0 : t1));
      }
      const auto curve = BRep_Tool::Curve(edge, t0, t1);
      if (curve.IsNull()) return false;
      if (!is_stray(edge)) tracks.push_back({curve, is_first ? t0 : t1});
    }
    const std::optional<Vec3> place = meet(at, sheets, tracks, apart);
    if (!place || (*place - at).norm() > kFarthestStray * gap) return false;
    places_[v] = *place;
    return true;
  }

  /// Ends an edge that stays where its vertices are to be; false where its curves do not go there.
  bool trim(const TopoDS_Edge& given, double apart) {
    const TopoDS_Edge edge = TopoDS::Edge(given.Oriented(TopAbs_FORWARD));
    Trimmed trimmed{edge, {}};
    const auto curve = BRep_Tool::Curve(edge, trimmed.range[0], trimmed.range[1]);
    const std::array<double, 2> old = trimmed.range;
    const std::array<int, 2> ends = ends_of(edge);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto place = places_.find(ends[i]);
      if (place == places_.end()) continue;
      Track track{curve, old[i]};
      if ((track.foot() - place->second).norm() <= Precision::Confusion()) continue;  // it ends there
      track.follow(place->second);
      if ((track.foot() - place->second).norm() > apart) return false;
      trimmed.range[i] = track.t;
    }
    const double length = old[1] - old[0], now = trimmed.range[1] - trimmed.range[0];
    if (!(now > 0.5 * length && now < 2.0 * length)) return false;
    for (const TopoDS_Shape& face : faces_at_.FindFromKey(edge)) {
      double s0 = 0.0, s1 = 0.0;
      const auto on_face = BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face), s0, s1);
      if (on_face.IsNull() || s0 != old[0] || s1 != old[1]) return false;
      if (on_face->IsPeriodic()) continue;
      if (trimmed.range[0] < on_face->FirstParameter() || trimmed.range[1] > on_face->LastParameter())
        return false;
    }
    trimmed_.push_back(trimmed);
    return true;
  }

  std::vector<EdgeRedrawn> apply() {
    std::vector<EdgeRedrawn> redrawn;
    std::vector<TopoDS_Edge> touched;
    const BRep_Builder builder;
    const double tolerance = Precision::Confusion();
    for (const auto& [v, place] : places_)
      builder.UpdateVertex(TopoDS::Vertex(edges_at_.FindKey(v)), to_pnt(place), tolerance);
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      const Stray& stray = strays_[i];
      builder.UpdateEdge(stray.edge, drawn_[i].in_space, tolerance);
      for (std::size_t k = 0; k < 2; ++k)
        builder.UpdateEdge(stray.edge, drawn_[i].on_face[k], stray.faces[k], tolerance);
      builder.Range(stray.edge, drawn_[i].in_space->FirstParameter(), drawn_[i].in_space->LastParameter());
      redrawn.push_back({stray.edge, stray.gap});
      touched.push_back(stray.edge);
    }
    for (const Trimmed& trimmed : trimmed_) {
      builder.Range(trimmed.edge, trimmed.range[0], trimmed.range[1]);
      touched.push_back(trimmed.edge);
    }
    if (!touched.empty()) lower_tolerances(all_, touched);
    return redrawn;
  }

  TopoDS_Shape all_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_at_, edges_at_;
  std::vector<Stray> strays_;
  Places places_;
  std::vector<Trimmed> trimmed_;
  std::vector<Drawn> drawn_;  ///< of the strays
};

}  // namespace

std::vector<EdgeRedrawn> redraw_stray_edges(const std::vector<TopoDS_Shape>& solids) {
  return Redrawing(solids).run();
}

}  // namespace octet
