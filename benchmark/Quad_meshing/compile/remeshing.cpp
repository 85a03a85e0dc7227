// The yardstick: a program that calls one function of CGAL, in the style of CGAL's examples.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <fstream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  Mesh tm;
  std::ifstream("fandisk.off") >> tm;
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(tm), 0.04, tm, CGAL::parameters::number_of_iterations(3));
  std::ofstream("remeshed.off") << tm;
}
