// Times meshoptimizer at the work of this library's levels of detail: three simplifications of a creature's mesh, each put into the order of a vertex cache and of vertex fetches.
#include "meshoptimizer.h"
#include "subject.h"

namespace {

// Parts of the triangles that the levels keep, as this library's do.
const double kFractions[] = {0.5, 0.25, 0.1};

// Of the mesh's extent; far above what is reached, so that the count decides.
const float kMaxError = 0.1f;

std::vector<Subject> subjects;

std::vector<uint32_t> Simplified(const Subject& s, double fraction) {
  std::vector<uint32_t> indices(s.triangles.size());
  const size_t target = static_cast<size_t>(s.triangles.size() / 3 * fraction) * 3;
  const size_t count = meshopt_simplify(indices.data(), s.triangles.data(), s.triangles.size(), s.positions.data(), s.Vertices(), sizeof(float) * 3, target, kMaxError, 0, nullptr);
  indices.resize(count);
  meshopt_optimizeVertexCache(indices.data(), indices.data(), count, s.Vertices());
  return indices;
}

void Levels(const Subject& s) {
  for (const double fraction : kFractions) {
    std::vector<uint32_t> indices = Simplified(s, fraction);
    std::vector<float> fetched(s.positions.size());
    meshopt_optimizeVertexFetch(fetched.data(), indices.data(), indices.size(), s.positions.data(), s.Vertices(), sizeof(float) * 3);
  }
}

}  // namespace

int main() {
  return Obey(
      [](const std::string& folder) { subjects = Subject::ReadAll(folder); },
      [](const std::string& name) {
        if (name != "levels") throw std::invalid_argument("no row '" + name + "'");
        Row row;
        for (const Subject& s : subjects) row.items.push_back([&s] { Levels(s); });
        return row;
      });
}
