// SPDX-License-Identifier: BSD-3-Clause
// Claims about measures: nodes on their entity; length, area and volume within the chord error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/segment.h"
#include "classify/claims.h"
#include "geom/edge_turn.h"

namespace octet {
namespace {

// What the measures of flat and straight entities agree to, relative.
constexpr double kExact = 1e-9;

/// A triangle that is off by more than half of itself may not claim more for it.
double capped_share(double share) { return std::min(share, 0.5); }

double area_of(const ClaimInput& in, std::uint32_t t) { return 0.5 * in.cross(in.mesh.triangles[t]).norm(); }

double circumradius(const ClaimInput& in, std::uint32_t t) {
  const auto& v = in.mesh.triangles[t];
  const double sides = (in.point(v[0]) - in.point(v[1])).norm() * (in.point(v[1]) - in.point(v[2])).norm() *
                       (in.point(v[2]) - in.point(v[0])).norm();
  const double area = area_of(in, t);
  return area > 0.0 ? sides / (4.0 * area) : in.longest_side(v);
}

struct PieceMeasure {
  double chord = 0.0;
  double sagitta = 0.0;       ///< largest distance of the curve from the chord, at three places
  Vec3 place = Vec3::Zero();  ///< of the sagitta
  double excess = 0.0;        ///< length of the curve beyond its own chord
};

PieceMeasure measure_piece(const ClaimInput& in, std::uint32_t e) {
  const auto [a, b] = in.mesh.edges[e];
  const int tag = in.mesh.edge_on[e];
  const ModelEdge& edge = in.model.edge(tag);
  PieceMeasure m;
  m.chord = (in.point(b) - in.point(a)).norm();
  const double ta = in.mesh.point_on[a].dim == 1 ? in.node_foot[a].t : edge.t0;
  const double tb = in.mesh.point_on[b].dim == 1 ? in.node_foot[b].t : edge.t1;
  if (edge.use == EdgeUse::kDegenerate || tb <= ta) return m;  // the claim edge-chains tells
  for (const double s : {0.25, 0.5, 0.75}) {
    const Vec3 p = in.model.edge_point(tag, ta + s * (tb - ta));
    const double distance = distance_to_segment(p, in.point(a), in.point(b));
    if (distance <= m.sagitta) continue;
    m.sagitta = distance;
    m.place = p;
  }
  m.excess = in.model.edge_length(tag, ta, tb) -
             (in.model.edge_point(tag, tb) - in.model.edge_point(tag, ta)).norm();
  return m;
}

/// Sums over the pieces of one model edge.
struct EdgeSums {
  double chords = 0.0;
  double length_error = 0.0;  ///< sum of what chords may fall short
  double area_error = 0.0;    ///< between chords and curve
  double volume_error = 0.0;
  Farthest farthest;
};

// An arc of sagitta s over a chord c is longer by 8 s^2 / (3 c), and has the area 2 s c / 3. An S of the same
// sagitta is longer by four times as much: hence 11. Where the curve bends between the places that the
// sagitta is taken at, its own length tells. The shares of c bound what a piece that leaves the curve
// altogether may claim for itself.
EdgeSums edge_sums(const ClaimInput& in, int tag) {
  EdgeSums sums;
  for (const std::uint32_t e : in.pieces_on[tag]) {
    const PieceMeasure m = measure_piece(in, e);
    sums.chords += m.chord;
    if (m.sagitta > sums.farthest.distance) sums.farthest = {model_edge(tag), m.place, m.sagitta};
    if (m.chord <= 0.0) continue;
    sums.length_error += std::min(std::max(11.0 * m.sagitta * m.sagitta / m.chord, 1.1 * m.excess),
                                  (kMostOverChord - 1.0) * m.chord);
    sums.area_error += 1.4 * std::min(m.sagitta, 0.5 * m.chord) * m.chord;
    sums.volume_error += 2.0 * std::pow(std::min(m.sagitta, 0.5 * m.chord), 2) * m.chord;
  }
  return sums;
}

std::vector<EdgeSums> all_edge_sums(const ClaimInput& in) {
  std::vector<EdgeSums> sums(in.pieces_on.size());
  for (std::size_t tag = 1; tag < sums.size(); ++tag) sums[tag] = edge_sums(in, static_cast<int>(tag));
  return sums;
}

struct FaceSums {
  double area = 0.0;
  double area_error = 0.0;
  double volume_error = 0.0;
};

/// What tolerances alone may change on a face: how far its nodes and edges may be off.
double face_slack(const ClaimInput& in, int tag) {
  const ModelFace& face = in.model.face(tag);
  double slack = face.tolerance + in.model.tolerance();
  for (const FaceBoundary& b : face.boundary) slack = std::max(slack, in.model.edge(b.edge).tolerance);
  double off = 0.0;
  for (const std::uint32_t t : in.triangles_on[tag])
    for (const Mesh::Index v : in.mesh.triangles[t])
      off = std::max(off, std::min(in.node_foot[v].distance, in.allowed_distance(in.mesh.point_on[v])));
  return slack + off;
}

/// How far the triangle's corners on vertices may lie off its face: only there, whereas a vertex' tolerance
/// may be a thousand times that of the faces around it (solids fused across a gap).
double corner_slack(const ClaimInput& in, std::uint32_t t) {
  double slack = 0.0;
  for (const Mesh::Index v : in.mesh.triangles[t])
    if (in.mesh.point_on[v].dim == 0)
      slack = std::max(slack, in.model.vertex(in.mesh.point_on[v].tag).tolerance);
  return slack;
}

// On a surface of curvature k a triangle of circumradius R is tilted by up to k R, so its area is off by a
// share of (k R)^2 / 2, and its plane lies k R^2 / 2 from the surface; both taken twice or so, since k is
// known at a few places only.
FaceSums face_sums(const ClaimInput& in, int tag, const std::vector<EdgeSums>& edges) {
  FaceSums sums;
  const ModelFace& face = in.model.face(tag);
  double perimeter = 0.0;
  for (const std::uint32_t t : in.triangles_on[tag]) {
    const double area = area_of(in, t);
    const double radius = circumradius(in, t);
    const TriangleFoot& foot = in.triangle_foot[t];
    const double tilt = foot.curvature * radius;
    const double height = std::max(foot.curvature * radius * radius, 1.5 * foot.distance);
    sums.area += area;
    // The angle is noise where the surface is flat.
    const double turn = foot.curvature > 0.0 ? foot.turn : 0.0;
    sums.area_error += area * capped_share(tilt * tilt + turn * turn);
    sums.volume_error +=
        foot.curvature > 0.0 ? area * std::min(height, 0.5 * in.longest_side(in.mesh.triangles[t])) : 0.0;
    const double off = corner_slack(in, t);
    sums.area_error += off * in.longest_side(in.mesh.triangles[t]);
    sums.volume_error += off * area;
  }
  for (const FaceBoundary& b : face.boundary) {
    sums.area_error += edges[b.edge].area_error;
    sums.volume_error += edges[b.edge].volume_error;
    perimeter += edges[b.edge].chords;
  }
  const double slack = face_slack(in, tag);
  sums.area_error += kExact * face.area + slack * perimeter;
  sums.volume_error += slack * sums.area;
  return sums;
}

std::vector<FaceSums> all_face_sums(const ClaimInput& in) {
  const auto edges = all_edge_sums(in);
  std::vector<FaceSums> sums(in.triangles_on.size());
  for (std::size_t tag = 1; tag < sums.size(); ++tag) sums[tag] = face_sums(in, static_cast<int>(tag), edges);
  return sums;
}

/// Adds a comparison; returns the difference as a share of what is allowed.
double compare(ClaimBuilder& claim, ModelRef entity, const Vec3& place, const char* what, double found,
               double asked, double allowed) {
  const double difference = std::abs(found - asked);
  const double share = difference == 0.0 ? 0.0 : difference / std::max(allowed, 1e-300);
  if (!(share <= 1.0))
    claim.fault(share, entity, place,
                fmt::format("the mesh has {} {:.9g}, the CAD {:.9g}; the mesh size explains {:.3g} of the "
                            "difference {:.3g}",
                            what, found, asked, allowed, difference),
                kFiner);
  return share;
}

Vec3 place_of_face(const ClaimInput& in, int tag) {
  const auto& triangles = in.triangles_on[tag];
  return triangles.empty() ? in.model.box().centre() : in.centroid(in.mesh.triangles[triangles[0]]);
}

}  // namespace

Claim claim_nodes_on_entity(const ClaimInput& in) {
  ClaimBuilder claim("nodes-on-entity",
                     "Every vertex lies on its entity within tolerance; worst: share of what is allowed.");
  double worst = 0.0;
  for (Mesh::Index v = 0; v < in.mesh.points.size(); ++v) {
    const ModelRef ref = in.mesh.point_on[v];
    if (ref.dim == 3) continue;
    const double share = in.node_foot[v].distance / in.allowed_distance(ref);
    worst = std::max(worst, share);
    if (share <= 1.0) continue;
    claim.fault(share, ref, in.point(v), fmt::format("vertex {} is {:.3g} off", v, in.node_foot[v].distance),
                kBadMesh);
  }
  return claim.measured(worst, 1.0);
}

Claim claim_edge_length(const ClaimInput& in) {
  ClaimBuilder claim("edge-length",
                     "Every edge's length is the CAD's within the chord error; worst: share of that.");
  double worst = 0.0;
  Farthest farthest;
  const auto sums = all_edge_sums(in);
  for (int tag = 1; tag <= in.model.count(1); ++tag) {
    const ModelEdge& edge = in.model.edge(tag);
    if (edge.use != EdgeUse::kReal) continue;
    if (sums[tag].farthest.distance > farthest.distance) farthest = sums[tag].farthest;
    double slack = kExact * edge.length + 2.0 * (edge.tolerance + in.model.tolerance());
    // The chain ends in the vertices, which may lie off the curve's ends.
    for (const int v : edge.vertex)
      if (v > 0) slack += in.model.vertex(v).tolerance;
    for (const std::uint32_t e : in.pieces_on[tag])
      for (const Mesh::Index v : in.mesh.edges[e])
        slack += std::min(in.node_foot[v].distance, in.allowed_distance(in.mesh.point_on[v]));
    // Where the chords are farthest off is where smaller elements help.
    const Vec3 place = sums[tag].farthest.distance > 0.0
                           ? sums[tag].farthest.place
                           : in.model.edge_point(tag, 0.5 * (edge.t0 + edge.t1));
    worst = std::max(worst, compare(claim, model_edge(tag), place, "the length", sums[tag].chords,
                                    edge.length, sums[tag].length_error + slack));
  }
  Claim measured = claim.measured(worst, 1.0);
  if (farthest.entity.valid()) measured.farthest = farthest;
  return measured;
}

Claim claim_face_area(const ClaimInput& in) {
  ClaimBuilder claim("face-area",
                     "Every face's area is the CAD's within the chord error; worst: share of that.");
  double worst = 0.0;
  const auto sums = all_face_sums(in);
  for (int tag = 1; tag <= in.model.count(2); ++tag)
    worst = std::max(worst, compare(claim, model_face(tag), place_of_face(in, tag), "the area",
                                    sums[tag].area, in.model.face(tag).area, sums[tag].area_error));
  return claim.measured(worst, 1.0);
}

Claim claim_region_volume(const ClaimInput& in) {
  ClaimBuilder claim("region-volume",
                     "Every region's volume is the CAD's within the chord error; worst: share of that.");
  double worst = 0.0;
  const auto faces = all_face_sums(in);
  for (int tag = 1; tag <= in.model.count(3); ++tag) {
    const ModelRegion& region = in.model.region(tag);
    double allowed = kExact * std::abs(region.volume);
    for (const int face : region.faces) allowed += faces[face].volume_error;
    const Vec3 place = region.faces.empty() ? in.model.box().centre() : place_of_face(in, region.faces[0]);
    worst = std::max(worst, compare(claim, model_region(tag), place, "the volume", in.sweep.filled[tag],
                                    region.volume, allowed));
  }
  return claim.measured(worst, 1.0);
}

}  // namespace octet
