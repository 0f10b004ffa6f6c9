// The rigid scenes of tests/bench in Box2D: box2d incline|wall <dt> <velocity iterations> [courses]. Prints BENCH,
// bodies and the error as the scenes of Talus do.
#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

b2Body* box(b2World& world, b2BodyType type, b2Vec2 centre, float width, float height, float angle, float friction) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = centre;
  definition.angle = angle;
  b2PolygonShape shape;
  shape.SetAsBox(width / 2, height / 2);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 2600;
  fixture.friction = friction;  // of a pair: √(a b)
  b2Body* body = world.CreateBody(&definition);
  body->CreateFixture(&fixture);
  return body;
}

double incline(double dt, int iterations) {
  const double g = 9.81, alpha = M_PI / 6, phi = M_PI / 9;
  b2World world(b2Vec2(0, float(-g)));
  const auto at = [&](double x, double y) {
    return b2Vec2(float(x * std::cos(alpha) + y * std::sin(alpha)), float(-x * std::sin(alpha) + y * std::cos(alpha)));
  };
  const float friction = float(std::tan(phi));
  box(world, b2_staticBody, at(29, -0.5), 62, 1, float(-alpha), friction);
  b2Body* block = box(world, b2_dynamicBody, at(0.5, 0.25), 1, 0.5, float(-alpha), friction);
  const b2Vec2 start = block->GetPosition();
  const int steps = int(std::lround(2 / dt));
  for (int i = 0; i < steps; ++i) world.Step(float(dt), iterations, 3);
  const double way = (block->GetPosition() - start).Length();
  return std::abs(way / (0.5 * g * (std::sin(alpha) - std::cos(alpha) * std::tan(phi)) * 4) - 1);
}

double wall(double dt, int iterations, int courses, int& bodies) {
  b2World world(b2Vec2(0, -9.81f));
  const float friction = float(std::tan(35 * M_PI / 180));
  box(world, b2_staticBody, b2Vec2(float(courses) / 2, -0.5f), float(courses + 2), 1, 0, friction);
  std::vector<std::pair<b2Body*, b2Vec2>> bricks;
  for (int course = 0; course < courses; ++course) {
    const bool half = course % 2 == 1;
    double from = 0;
    while (from < courses - 1e-9) {
      const double length = half && (from == 0 || from > courses - 0.6) ? 0.5 : 1;
      const b2Vec2 centre(float(from + length / 2), float(0.5 * course + 0.25));
      bricks.push_back({box(world, b2_dynamicBody, centre, float(length), 0.5f, 0, friction), centre});
      from += length;
    }
  }
  bodies = int(bricks.size()) + 1;
  const int steps = int(std::lround(1 / dt));
  for (int i = 0; i < steps; ++i) world.Step(float(dt), iterations, 3);
  double most = 0;
  for (const auto& [body, start] : bricks) most = std::max(most, double((body->GetPosition() - start).Length()));
  return most / 0.5;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const double dt = std::atof(arguments[2]);
  const int iterations = std::atoi(arguments[3]);
  int bodies = 2;
  const double error = std::string(arguments[1]) == "incline"
                           ? incline(dt, iterations)
                           : wall(dt, iterations, count > 4 ? std::atoi(arguments[4]) : 10, bodies);
  std::printf("BENCH %d %.6g\n", bodies, error);
}
