// SPDX-License-Identifier: BSD-3-Clause
// One round: find the holes, propose a point for each, insert it with its partner, label what changed.
#include "app/attribute_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "base/error.h"
#include "base/sort_unique.h"
#include "base/vertex_order.h"
#include "classify/dual_crossings.h"
#include "geom/face_match.h"
#include "geom/opposite.h"

namespace octet {
namespace {

/// Sheets closer than this share of the point's clearance get a partner.
constexpr double kMatchShare = 0.9;
/// A partner this close to a point that is there already has its partner: the ball of that point.
constexpr double kSamePoint = 0.25;
/// Sheets are on one another where they are nearer than this share of the distance to other points; a partner
/// farther than this share of their own distance off its place is none.
constexpr double kThinGap = 0.25, kOffPartner = 0.5;
/// Sheets on one another that get partners of one point.
constexpr int kSheets = 4;

class AttributeLoop {
 public:
  AttributeLoop(Triangulation& triangulation, Band& band, EdgeChains& chains, std::vector<ModelRef>& on,
                const EdgeIndex& edges, const AttributeLimits& limits)
      : triangulation_(triangulation),
        band_(band),
        chains_(chains),
        on_(on),
        edges_(edges),
        limits_(limits),
        model_(band.model()) {}

  AttributeResult run(Observer& observer) {
    for (result_.rounds = 0; result_.rounds < limits_.rounds; ++result_.rounds) {
      if (observer.cancelled()) throw Cancelled();
      look();
      if (result_.gaps.empty()) look_along_duals();
      observer.note(round_text());
      if (result_.gaps.empty() || result_.points >= limits_.points || runs_away()) return finished();
      const std::size_t before = result_.points;
      for (const Gap& gap : result_.gaps) match_corners_within_bound(gap);
      for (const Gap& gap : result_.gaps) close_within_bound(gap);
      relabel();
      if (result_.points == before) return finished();
    }
    look();
    return finished();
  }

 private:
  [[nodiscard]] const TetMesh& mesh() const { return triangulation_.mesh(); }

  /// Finds the gaps that labels alone cannot close.
  void look() {
    band_.repair(mesh(), on_, chains_);
    result_.gaps = find_gaps(band_, mesh(), on_, chains_, memory_, limits_.scope);
    std::vector<std::uint32_t> fans;
    for (const Gap& gap : result_.gaps)
      if (gap.kind == GapKind::kEdgeFan && gap.piece != UINT32_MAX) fans.push_back(gap.piece);
    std::sort(fans.begin(), fans.end());
    if (!fans.empty() && band_.repair_beside(mesh(), on_, chains_, fans) > 0)
      result_.gaps = find_gaps(band_, mesh(), on_, chains_, memory_, limits_.scope);
    only_bare_vertices_ = std::all_of(result_.gaps.begin(), result_.gaps.end(),
                                      [](const Gap& gap) { return gap.kind == GapKind::kBareVertex; });
    bare_faces_.clear();
    for (const Gap& gap : result_.gaps)
      if (gap.kind == GapKind::kBareFace) bare_faces_.insert(gap.entity.tag);
  }

  /// Dual crossings are no holes: points may end them, but the mesh is right with them.
  AttributeResult finished() {
    std::erase_if(result_.gaps, [](const Gap& gap) { return gap.kind == GapKind::kDualCrossing; });
    if (!result_.gaps.empty()) list_crowded_cells();
    return std::move(result_);
  }

  /// A cell that took as many points as its eight parts would have had is too large for the part there.
  void list_crowded_cells() {
    constexpr std::size_t kCrowd = 8;
    for (const auto& [cell, points] : spent_) {
      if (points >= kCrowd) result_.crowded.push_back(cell);
    }
    std::sort(result_.crowded.begin(), result_.crowded.end());
  }

  /// Once the surface is closed. What a few rounds do not part stays: a closed surface with each face's
  /// topology is right, and the acceptance tests that.
  void look_along_duals() {
    constexpr int kDualRounds = 4;
    if (dual_rounds_ == kDualRounds) return;
    ++dual_rounds_;
    result_.gaps = find_dual_crossings(band_, mesh(), on_);
  }

  /// The bound of each cell ends every run; where gaps grow, or do not get fewer, all over the part (a
  /// surface that folds over itself), this ends it sooner.
  bool runs_away() {
    constexpr std::size_t kPatience = 12, kGrowth = 3, kFew = 60, kLooks = 4, kMany = 1000;
    if (std::all_of(result_.gaps.begin(), result_.gaps.end(),
                    [](const Gap& gap) { return gap.kind == GapKind::kMissingPiece; }))
      return false;  // facets have not been looked at in this round
    const auto now =
        static_cast<std::size_t>(std::count_if(result_.gaps.begin(), result_.gaps.end(), [&](const Gap& gap) {
          return spent_at(gap.place) < limits_.per_cell;
        }));
    if (looks_++ == 0) first_ = now;
    fewest_ = std::min(fewest_, now);
    return now > limits_.gaps || (looks_ >= kLooks && now > first_ / 2 + kMany) ||
           (result_.rounds >= kPatience && now > kGrowth * fewest_ + kFew);
  }

  [[nodiscard]] std::string round_text() const {
    std::array<std::size_t, 7> kinds{};
    for (const Gap& gap : result_.gaps) ++kinds[static_cast<std::size_t>(gap.kind)];
    return fmt::format(
        "round {}: {} attribute points; gaps: {} edge pieces, {} faceless, {} edge fans, {} vertex fans, {} "
        "bare vertices, {} bare faces, {} dual crossings",
        result_.rounds, result_.points, kinds[0], kinds[1], kinds[2], kinds[3], kinds[4], kinds[5], kinds[6]);
  }

  /// Points spent on the gaps of the cell that holds a place.
  std::size_t& spent_at(const Vec3& place) { return spent_[limits_.cell_at ? limits_.cell_at(place) : 0]; }

  /// Where points make more gaps than they close (a cusp, a fold within a tolerance) more of them do not
  /// help: each cell has so many, and what is open there then stays open, whatever happens elsewhere.
  void close_within_bound(const Gap& gap) {
    std::size_t& spent = spent_at(gap.place);
    if (spent >= limits_.per_cell) return;
    const std::size_t before = result_.points;
    close(gap);
    spent += result_.points - before;
  }

  void match_corners_within_bound(const Gap& gap) {
    if (gap.kind != GapKind::kNoFace) return;
    std::size_t& spent = spent_at(gap.place);
    if (spent >= limits_.per_cell) return;
    const std::size_t before = result_.points;
    match_corners(gap);
    spent += result_.points - before;
  }

  /// A facet between sheets that lie on one another much nearer than its corners to each other, as at a cusp,
  /// has a corner whose partner on the other sheet is missing, or is not near enough across: it gets one.
  /// Partners of model vertices are left to match_apexes: in assemblies of thin sheets they made walls cross.
  void match_corners(const Gap& gap) {
    if (changed(gap.tet) || changed(mesh().neighbours[gap.tet][gap.local])) return;
    std::array<VertexId, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = mesh().tets[gap.tet][kTetFace[gap.local][i]];
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = mesh().points[corner[i]];
      const double clear = std::min((p - mesh().points[corner[(i + 1) % 3]]).norm(),
                                    (p - mesh().points[corner[(i + 2) % 3]]).norm());
      if (on_[corner[i].index()].dim > 0) match_corner(corner[i], kThinGap * clear);
    }
  }

  /// A tetrahedron that has a corner behind a sheet much nearer than its other corners reaches through it:
  /// the corner's partner on the sheet is missing.
  void match_apexes(const Gap& gap) {
    std::array<VertexId, 3> facet;
    for (int i = 0; i < 3; ++i) facet[i] = mesh().tets[gap.tet][kTetFace[gap.local][i]];
    const auto of_facet = [&](VertexId w) { return std::find(facet.begin(), facet.end(), w) != facet.end(); };
    for (const TetId t : {gap.tet, mesh().neighbours[gap.tet][gap.local]}) {
      if (changed(t) || mesh().ghost(t)) continue;
      const auto v = mesh().tets[t];
      const VertexId apex = *std::find_if_not(v.begin(), v.end(), of_facet);
      double clear = std::numeric_limits<double>::infinity();
      for (const VertexId w : v)
        if (w != apex) clear = std::min(clear, (mesh().points[w] - mesh().points[apex]).norm());
      match_corner(apex, kThinGap * clear);
    }
  }

  void match_corner(VertexId v, double reach) {
    const ModelRef on = on_[v.index()];
    const Vec3 p = mesh().points[v];
    const auto match = [&](int face, const Vec3& b) {
      const double off = kOffPartner * (b - p).norm();
      const TetId near = triangulation_.tet_at(v);
      if (!near_a_point_of(model_face(face), b, off, near)) insert(b, model_face(face), near);
    };
    if (on.dim < 2) {
      const Vec3 tangent =
          on.dim == 0 ? Vec3::Zero() : model_.edge_derivative(on.tag, model_.edge_closest(on.tag, p).t);
      for (const FacePartner& b : face_partners(model_, on, p, tangent, reach)) match(b.face, b.point);
    } else if (on.dim == 2) {
      const Vec3 normal = model_.face_project(on.tag, p).normal;
      for (const int side : {-1, 1}) {
        const auto b = opposite_point(model_, p, on.tag, normal, side, reach);
        if (b && b->on.dim == 2) match(b->on.tag, b->point);
      }
    }
  }

  void close(const Gap& gap) {
    if (gap.piece != UINT32_MAX) {
      if (is_split(gap)) return;
      if (gap.kind == GapKind::kMissingPiece || (!close_beside(gap.piece) && is_distinct(gap.piece)))
        split(gap.piece);
      return;
    }
    if (gap.kind == GapKind::kBareVertex) {
      close_bare_vertex(gap);
      return;
    }
    if (gap.kind == GapKind::kBareFace) return;  // its bare vertices get company, or smaller octants find it
    if (changed(gap.tet) || changed(mesh().neighbours[gap.tet][gap.local])) return;
    const std::size_t before = result_.points;
    const auto point = facet_point(model_, mesh(), on_, gap.tet, gap.local, limits_.floor);
    if (point)
      insert_at(*point, gap.tet);
    else
      ++result_.rejected;
    if (gap.kind != GapKind::kNoFace) return;
    if (result_.points == before) close_behind(gap);
    if (result_.points == before) match_apexes(gap);
  }

  void insert_at(const AttributePoint& point, TetId near) {
    if (point.on.dim == 1)
      split_at(point.on.tag, point.t);
    else
      insert_on_face(point, near);
  }

  /// Where a repair has moved tetrahedra because their own facets, behind this one, fit no face, and the
  /// place that this one asks for has a point already, one of those gets a point: a fillet with all of its
  /// points in the middle is cut off by a chord from edge to edge, and lacks points to either side.
  void close_behind(const Gap& gap) {
    constexpr std::size_t kMost = 16;
    struct Moved {
      TetId tet;
      int own;  ///< region before the repair
    };
    std::vector<Moved> moved;
    const auto own = [&](TetId t) { return band_.own_region(mesh(), on_, t).value_or(band_.region(t)); };
    const auto add = [&](TetId t, int region) {
      if (moved.size() < kMost && region != band_.region(t) &&
          std::none_of(moved.begin(), moved.end(), [t](const Moved& m) { return m.tet == t; }))
        moved.push_back({t, region});
    };
    for (const TetId t : {gap.tet, mesh().neighbours[gap.tet][gap.local]}) add(t, own(t));
    std::optional<AttributePoint> best;
    TetId at;
    for (std::size_t i = 0; i < moved.size(); ++i)
      for (int f = 0; f < 4; ++f) {
        const auto [tet, region] = moved[i];
        const TetId beyond = mesh().neighbours[tet][f];
        if (changed(beyond)) return;
        const int region_beyond = own(beyond);
        add(beyond, region_beyond);
        if (region_beyond == region) continue;
        const auto point = facet_point(model_, mesh(), on_, tet, f, limits_.floor);
        if (!point || (best && point->clearance <= best->clearance)) continue;
        best = point;
        at = tet;
      }
    if (best) insert_at(*best, at);
  }

  /// A tetrahedron at the piece that reaches through a sheet without points takes the facets from the piece:
  /// the sheet gets a point, the piece stays whole.
  bool close_beside(std::uint32_t piece) {
    const VertexId a(chains_[piece].a), b(chains_[piece].b);
    std::vector<TetId> star;
    triangulation_.star(a, star);
    std::optional<AttributePoint> best;
    TetId at;
    for (const TetId t : star) {
      const auto& v = mesh().tets[t];
      if (changed(t)) return true;  // what the piece lacks may have come in this round
      if (std::find(v.begin(), v.end(), b) == v.end()) continue;
      const auto offer = [&](const std::optional<AttributePoint>& point) {
        if (!point || (best && point->clearance <= best->clearance)) return;
        best = point;
        at = t;
      };
      offer(reach_point(model_, mesh(), on_, t, limits_.floor));
      if (mesh().ghost(t)) continue;
      for (int f = 0; f < 4; ++f)
        if (v[f] != a && v[f] != b)
          offer(hidden_sheet_point(model_, mesh(), on_, t, f, is_facet(t, f), limits_.floor));
    }
    if (best) insert_on_face(*best, at);
    return best.has_value();
  }

  [[nodiscard]] bool is_facet(TetId t, int local) const {
    return band_.is_facet(mesh(), t, static_cast<std::int8_t>(local));
  }

  /// Whether the CAD tells the halves of a piece apart: splitting on below its tolerance mends no fan.
  [[nodiscard]] bool is_distinct(std::uint32_t piece) const {
    const EdgePiece& p = chains_[piece];
    const double length = (mesh().points[VertexId(p.a)] - mesh().points[VertexId(p.b)]).norm();
    return length > 4.0 * model_.tolerance_of(model_edge(p.edge));
  }

  /// Whether another gap of this round has split the piece already.
  [[nodiscard]] bool is_split(const Gap& gap) const {
    const EdgePiece& p = chains_[gap.piece];
    const Vec3 middle = 0.5 * (mesh().points[VertexId(p.a)] + mesh().points[VertexId(p.b)]);
    return (middle - gap.place).squaredNorm() > 0.0;
  }

  /// Whether the tetrahedron that a gap speaks of has gone in this round, its slot reused or not.
  [[nodiscard]] bool changed(TetId t) const {
    return !mesh().alive(t) || (t.index() < changed_.size() && changed_[t.index()]);
  }

  void split(std::uint32_t piece) {
    const AttributePoint p = split_point(model_, mesh(), on_, chains_[piece]);
    if (split_piece(piece, p.t, p.point, p.clearance))
      match_edge_point(p.on.tag, p.t, p.point, p.clearance, kSheets);
  }

  /// Partners on edges and faces for a point that has just split an edge, and partners of these.
  void match_edge_point(int edge, double t, const Vec3& p, double clearance, int sheets) {
    if (sheets == 0) return;
    const TetId at = last_;
    const double reach = kMatchShare * clearance;
    for (const EdgePartner& b : edges_.partners(edge, t, reach)) match_on_edge(b, clearance, sheets - 1);
    for (const FacePartner& b :
         face_partners(model_, model_edge(edge), p, model_.edge_derivative(edge, t), reach))
      if (match_on_face(model_face(b.face), b.point, clearance, at))
        match_sheets(b.point, b.face, b.normal, clearance, sheets - 1);
  }

  /// Whether the point went in: not where the face has one already.
  bool match_on_face(ModelRef face, const Vec3& b, double clearance, TetId near) {
    if (near.valid() && !mesh().alive(near)) near = TetId();
    return !near_a_point_of(face, b, kSamePoint * clearance, near) && insert(b, face, near);
  }

  void match_on_edge(const EdgePartner& b, double clearance, int sheets) {
    const std::uint32_t n = chains_.piece_at(b.edge, b.t);
    const EdgePiece& piece = chains_[n];
    const double near = std::min((b.point - mesh().points[VertexId(piece.a)]).norm(),
                                 (b.point - mesh().points[VertexId(piece.b)]).norm());
    if (near > kSamePoint * clearance && split_piece(n, b.t, b.point, near))
      match_edge_point(b.edge, b.t, b.point, near, sheets);
  }

  void split_at(int edge, double t) {
    const std::uint32_t n = chains_.piece_at(edge, t);
    const EdgePiece& piece = chains_[n];
    const double share = model_.edge_length(edge, piece.ta, t) / model_.edge_length(edge, piece.ta, piece.tb);
    if (share > 0.25 && share < 0.75) {
      const Vec3 p = model_.edge_point(edge, t);
      const double clearance = std::min(share, 1.0 - share) * model_.edge_length(edge, piece.ta, piece.tb);
      if (split_piece(n, t, p, clearance)) match_edge_point(edge, t, p, clearance, kSheets);
    } else {
      split(n);
    }
  }

  bool split_piece(std::uint32_t n, double t, const Vec3& point, double clearance) {
    if (clearance < limits_.floor) {
      ++result_.rejected;
      return false;
    }
    const EdgePiece piece = chains_[n];
    const std::optional<VertexId> v =
        insert(point, model_edge(piece.edge), triangulation_.tet_at(VertexId(piece.a)));
    if (!v) return false;
    chains_.split(n, *v, t);
    memory_.ask_again(VertexId(piece.a));
    memory_.ask_again(VertexId(piece.b));
    insert_images(model_edge(piece.edge), point, clearance);
    return true;
  }

  /// The images of a point that has just gone in.
  void insert_images(ModelRef on, const Vec3& p, double clearance) {
    if (!limits_.images || is_image_) return;
    is_image_ = true;
    const TetId last = last_;
    for (const ImagePoint& image : limits_.images(on, p)) {
      if (image.on.dim == 1)
        split_piece(chains_.piece_at(image.on.tag, image.t), image.t, image.point, clearance);
      else
        insert(image.point, image.on, TetId());
    }
    last_ = last;
    is_image_ = false;
  }

  void insert_on_face(const AttributePoint& p, TetId near) {
    if (split_encroached(p.point, near)) return;
    if (insert(p.point, p.on, near)) match_sheets(p.point, p.on.tag, p.normal, p.clearance, kSheets);
  }

  /// Partners of a point that has just gone in on a face, on the sheets that it sees on either side, and on
  /// those that these see: where sheets lie on one another, all or none have a point there.
  void match_sheets(const Vec3& a, int face, const Vec3& normal, double clearance, int sheets) {
    if (sheets == 0) return;
    const TetId at = last_;
    for (const int side : {-1, 1}) {
      const auto b = opposite_point(model_, a, face, normal, side, kMatchShare * clearance);
      if (!b || b->on.dim == 0) continue;
      if (b->on.dim == 1) {
        match_on_edge({b->on.tag, model_.edge_closest(b->on.tag, b->point).t, b->point}, clearance,
                      sheets - 1);
      } else if (face_each_other(a, normal, *b) && match_on_face(b->on, b->point, clearance, at)) {
        match_sheets(b->point, b->on.tag, b->normal, clearance, sheets - 1);
      }
    }
  }

  /// A face point inside the diametral ball of an edge piece would break the edge: the piece is split
  /// instead.
  bool split_encroached(const Vec3& p, TetId near) {
    std::vector<std::uint32_t> hit;
    triangulation_.conflicts(p, free_point_rank(on_.size()), near, cavity_);
    for (const TetId t : cavity_) {
      if (mesh().ghost(t)) continue;
      const auto& v = mesh().tets[t];
      for (const auto& e : kTetEdge) {
        const VertexId a = v[e[0]], b = v[e[1]];
        if (on_[a.index()].dim > 1 || on_[b.index()].dim > 1) continue;
        if ((p - mesh().points[a]).dot(p - mesh().points[b]) >= 0.0) continue;
        const std::uint32_t n = chains_.find(a, b);
        if (n != UINT32_MAX) hit.push_back(n);
      }
    }
    sort_unique(hit);
    for (const std::uint32_t n : hit) split(n);
    return !hit.empty();
  }

  /// Whether a point in the closure of the same entity lies closer than `radius`.
  bool near_a_point_of(ModelRef entity, const Vec3& p, double radius, TetId near) {
    triangulation_.conflicts(p, free_point_rank(on_.size()), near, cavity_);
    for (const TetId t : cavity_) {
      for (const VertexId v : mesh().tets[t]) {
        if (v == kGhostVertex || (mesh().points[v] - p).norm() > radius) continue;
        if (model_.in_closure(on_[v.index()], entity)) return true;
      }
    }
    return false;
  }

  /// A boundary point that no facet holds lies on a sheet its neighbours do not see: its partner is missing.
  void close_bare_vertex(const Gap& gap) {
    const Vec3 p = mesh().points[gap.vertex];
    const FaceFoot foot = model_.face_project(gap.entity.tag, p);
    double reach = 0.0;
    triangulation_.star(gap.vertex, cavity_);
    for (const TetId t : cavity_)
      for (const VertexId v : mesh().tets[t])
        if (v != kGhostVertex && v != gap.vertex) reach = std::max(reach, (mesh().points[v] - p).norm());
    bool inserted = false;
    for (const int side : {-1, 1}) {
      const auto b = opposite_point(model_, p, gap.entity.tag, foot.normal, side, reach);
      if (!b || b->on.dim != 2) continue;
      const TetId near = triangulation_.tet_at(gap.vertex);
      if (near_a_point_of(b->on, b->point, std::max(limits_.floor, 0.1 * b->distance), near)) continue;
      inserted = insert(b->point, b->on, near).has_value() || inserted;
    }
    const bool may_be_coarse = bare_faces_.count(gap.entity.tag) != 0 || only_bare_vertices_;
    if (!inserted && !(may_be_coarse && refine_around(gap))) ++result_.rejected;
  }

  /// Facets may be too coarse for a closed face to be told from what they shut off, or for a point beneath
  /// them, where all else is closed: the face gets a point beside a bare one, halfway to another of its
  /// points.
  bool refine_around(const Gap& gap) {
    triangulation_.star(gap.vertex, cavity_);
    std::vector<std::pair<double, VertexId>> beside;
    const Vec3 p = mesh().points[gap.vertex];
    for (const TetId t : cavity_)
      for (const VertexId v : mesh().tets[t])
        if (v != kGhostVertex && v != gap.vertex && on_[v.index()] == gap.entity)
          beside.emplace_back((mesh().points[v] - p).norm(), v);
    sort_unique(beside);
    return std::any_of(beside.begin(), beside.end(), [&](const auto& one) {
      const auto [length, v] = one;
      if (length < 4.0 * limits_.floor) return false;
      const FaceFoot foot = model_.face_project(gap.entity.tag, 0.5 * (p + mesh().points[v]));
      return match_on_face(gap.entity, foot.point, length, triangulation_.tet_at(gap.vertex));
    });
  }

  /// At p or elsewhere on its face; partners are matched with p, where the tetrahedra want it.
  std::optional<VertexId> insert(Vec3 p, ModelRef on, TetId near) {
    if (near.valid() && !mesh().alive(near)) near = TetId();
    if (on.dim == 2 && limits_.elsewhere) {
      const std::optional<OtherPlace> other = limits_.elsewhere(on.tag, p);
      if (other && !near_a_point_of(on, other->point, other->clear, near)) p = other->point;
    }
    const VertexId v = triangulation_.insert(p, free_point_rank(on_.size()), near, created_);
    if (v.index() < on_.size()) {
      ++result_.rejected;
      return std::nullopt;
    }
    on_.push_back(on);
    ++result_.points;
    changed_.resize(mesh().tets.size(), 0);
    for (const TetId t : created_) {
      changed_[t.index()] = 1;
      relabel_.push_back(t);
    }
    last_ = created_.empty() ? TetId() : created_.front();
    if (on.dim == 2) insert_images(on, p, 0.0);
    return v;
  }

  void relabel() {
    sort_unique(relabel_);
    band_.update(mesh(), on_, relabel_);
    memory_.add(mesh(), relabel_);
    for (const TetId t : relabel_) changed_[t.index()] = 0;
    relabel_.clear();
  }

  Triangulation& triangulation_;
  Band& band_;
  EdgeChains& chains_;
  std::vector<ModelRef>& on_;
  const EdgeIndex& edges_;
  AttributeLimits limits_;
  const Model& model_;
  AttributeResult result_;
  GapMemory memory_;
  int dual_rounds_ = 0;
  std::size_t looks_ = 0;  ///< rounds in which facets were looked at
  std::size_t first_ = 0, fewest_ = std::numeric_limits<std::size_t>::max();  ///< gaps open in such rounds
  std::unordered_map<std::size_t, std::size_t> spent_;                        ///< points by cell
  std::set<int> bare_faces_;           ///< without any facet in this round
  bool only_bare_vertices_ = false;    ///< there is no other gap in this round
  std::vector<std::uint8_t> changed_;  ///< per tetrahedron: made in this round
  std::vector<TetId> relabel_, created_, cavity_;
  TetId last_;
  bool is_image_ = false;  ///< what goes in has its images
};

}  // namespace

AttributeResult close_gaps(Triangulation& triangulation, Band& band, EdgeChains& chains,
                           std::vector<ModelRef>& on, const EdgeIndex& edges, const AttributeLimits& limits,
                           Observer& observer) {
  return AttributeLoop(triangulation, band, chains, on, edges, limits).run(observer);
}

}  // namespace octet
