#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <list>

#include "geometry/convex_parts.h"

namespace talus {

std::vector<ConvexPart> convex_parts(const Polyline& polygon) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Partition_traits_2<Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::type>;
  std::vector<Kernel::Point_2> points;
  for (const Vec2& p : polygon) points.emplace_back(p.x(), p.y());
  Traits::Polygon_2 corners;
  for (std::size_t k = 0; k < points.size(); ++k) corners.push_back(k);
  std::list<Traits::Polygon_2> found;
  CGAL::approx_convex_partition_2(corners.vertices_begin(), corners.vertices_end(), std::back_inserter(found),
                                  Traits(CGAL::make_property_map(points)));
  std::vector<ConvexPart> parts;
  for (const Traits::Polygon_2& part : found) parts.emplace_back(part.vertices_begin(), part.vertices_end());
  return parts;
}

}  // namespace talus
