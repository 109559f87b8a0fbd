// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <thread>

#include "robust/scene/detail/crowd_parts.h"
#include "robust/scene/solid.h"
#include "tests/robust/every_state/public_function.h"

namespace touchstone::every_state_tests {
namespace {

using scene::Scene;

scene::Faces faces_of(const Input& in) { return {{in.triangle}, {in.polygon}}; }

std::vector<Ball> balls_of(const Input& in) {
  return {in.ball, {in.ball.center, -0.0}, {in.point, 0}, {in.triangle.b, 0}, {in.polygon.vertex(2), -0.0}};
}

/// Enough balls to walk through a scene together, for a question for which `fewest` are enough on one core.
std::vector<Ball> crowd_of(const Input& in, std::size_t fewest = scene::detail::kFewestSearching) {
  static const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const std::vector<Ball> balls = balls_of(in);
  std::vector<Ball> crowd;
  while (crowd.size() < fewest * cores) crowd.push_back(balls[crowd.size() % balls.size()]);
  return crowd;
}

/// Whatever a scene says about the input's balls.
auto described(std::shared_ptr<const Scene> scene, const Input& in) {
  return [scene = std::move(scene), balls = balls_of(in)] {
    return std::pair(scene->touched(balls), scene->nearest(balls));
  };
}

/// What `ask` says of a scene that was made in the default state.
template <class Ask>
auto of_scene(const Ask& ask) {
  return [ask](const Input& in) {
    Scene scene;
    {
      const Environment usual(FE_TONEAREST, Environment::kKeep);
      scene.add("as it is", faces_of(in));
      try {
        scene.add("posed", faces_of(in), in.pose);
      } catch (const Rejected&) {  // then there is one object
      }
    }
    return ask(scene, in);
  };
}

/// Motions from ball to ball, short ones too, and one at rest.
std::vector<Motion> motions_of(const Input& in) {
  return {{in.ball, in.point}, {in.ball, in.triangle.b}, {{in.point, -0.0}, in.ball.center}, {in.ball, in.ball.center}};
}

/// What `ask` says about each motion.
template <class Ask>
auto of_motions(const Ask& ask) {
  return of_scene([ask](const Scene& scene, const Input& in) {
    std::vector<decltype(ask(scene, motions_of(in).front()))> answers;
    for (const Motion& motion : motions_of(in)) answers.push_back(ask(scene, motion));
    return answers;
  });
}

std::vector<PublicFunction> moving_functions() {
  return {
      gives("scene::Scene::touches", of_motions([](const Scene& s, const Motion& m) { return s.touches(m); })),
      gives("scene::Scene::touched", of_motions([](const Scene& s, const Motion& m) { return s.touched(m); })),
      gives("scene::Scene::first_contact",
            of_motions([](const Scene& s, const Motion& m) { return s.first_contact(m); })),
      gives("scene::Scene::touches", of_scene([](const Scene& scene, const Input& in) {
              const std::vector<Motion> motions = motions_of(in);
              std::array<bool, 4> touches{};
              scene.touches(motions, touches);
              return touches;
            })),
      gives("scene::Scene::touched",
            of_scene([](const Scene& scene, const Input& in) { return scene.touched(motions_of(in)); })),
      gives("scene::Scene::first_contact",
            of_scene([](const Scene& scene, const Input& in) { return scene.first_contact(motions_of(in)); })),
      gives("scene::Scene::touched_in_order",
            of_motions([](const Scene& s, const Motion& m) { return s.touched_in_order(m); })),
      gives("scene::Scene::touched_in_order",
            of_scene([](const Scene& scene, const Input& in) { return scene.touched_in_order(motions_of(in)); })),
  };
}

std::vector<PublicFunction> static_functions() {
  return {
      gives("scene::Scene::add",
            [](const Input& in) {
              const auto scene = std::make_shared<Scene>();
              scene->add("object", {{in.any_triangle}, {in.polygon}}, in.any_pose);
              return described(scene, in);
            }),
      gives("scene::Scene::set_pose",
            [](const Input& in) {
              const auto scene = std::make_shared<Scene>();
              for (int i = 0; i < 20; ++i) scene->add(std::to_string(i), faces_of(in));  // enough to be found by boxes
              try {
                scene->set_pose(7, in.any_pose);
              } catch (const Rejected&) {  // then it stays where it was
              }
              scene->remove(3);
              return described(scene, in);
            }),
      hands_on("scene::Scene::pose", of_scene([](const Scene& scene, const Input&) {
                 return scene.pose(static_cast<std::uint32_t>(scene.object_count() - 1));
               })),
      gives("scene::Scene::touches", of_scene([](const Scene& scene, const Input& in) {
              std::vector<bool> touches;
              for (const Ball& ball : balls_of(in)) touches.push_back(scene.touches(ball));
              return touches;
            })),
      gives("scene::Scene::touched", of_scene([](const Scene& scene, const Input& in) {
              std::vector<std::vector<scene::FaceId>> touched;
              for (const Ball& ball : balls_of(in)) touched.push_back(scene.touched(ball));
              return touched;
            })),
      gives("scene::Scene::nearest", of_scene([](const Scene& scene, const Input& in) {
              std::vector<std::optional<scene::NearestFace>> nearest;
              for (const Ball& ball : balls_of(in)) nearest.push_back(scene.nearest(ball));
              return nearest;
            })),
      gives("scene::Scene::touches", of_scene([](const Scene& scene, const Input& in) {
              const std::vector<Ball> balls = crowd_of(in, scene::detail::kFewestTouching);
              const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
              scene.touches(balls, {touches.get(), balls.size()});
              return std::vector<bool>(touches.get(), touches.get() + balls.size());
            })),
      gives("scene::Scene::touched", of_scene([](const Scene& scene, const Input& in) {
              return scene.touched(crowd_of(in, scene::detail::kFewestTouching));
            })),
      gives("scene::Scene::nearest",
            of_scene([](const Scene& scene, const Input& in) { return scene.nearest(crowd_of(in)); })),
      gives("scene::Scene::nearest", of_scene([](const Scene& scene, const Input& in) {
              const std::vector<Ball> balls = crowd_of(in);
              std::vector<std::optional<scene::NearestFace>> nearest(balls.size());
              scene.nearest(balls, [&](std::size_t i, const auto& found) { nearest[i] = found; });
              return nearest;
            })),
      gives("scene::Scene::nearest_face", of_scene([](const Scene& scene, const Input& in) {
              std::vector<std::optional<scene::FaceId>> nearest;
              for (const Ball& ball : balls_of(in)) nearest.push_back(scene.nearest_face(ball.center));
              return nearest;
            })),
      gives("scene::Scene::nearest_face", of_scene([](const Scene& scene, const Input& in) {
              std::vector<Eigen::Vector3d> centers;
              for (const Ball& ball : crowd_of(in)) centers.push_back(ball.center);
              return scene.nearest_face(centers);
            })),
  };
}

/// The tetrahedron over the input's triangle, unless it is flat.
std::vector<Triangle> tetrahedron_of(const Input& in) {
  const Triangle& t = in.triangle;
  return {{t.a, t.c, t.b}, {t.a, t.b, in.point}, {t.b, t.c, in.point}, {t.c, t.a, in.point}};
}

/// Points on the tetrahedron and level with its vertices; no state changes what is only copied.
std::vector<Eigen::Vector3d> points_of(const Input& in) {
  const Triangle& t = in.triangle;
  return {in.ball.center, in.point, t.b, {t.a.x(), t.b.y(), in.point.z()}, {in.point.x(), t.c.y(), t.a.z()}};
}

/// What `ask` says of a solid that was made in the default state.
template <class Ask>
auto of_solid(const Ask& ask) {
  return [ask](const Input& in) {
    std::unique_ptr<const scene::Solid> solid;
    {
      const Environment usual(FE_TONEAREST, Environment::kKeep);
      solid = std::make_unique<const scene::Solid>(tetrahedron_of(in));
    }
    return ask(*solid, points_of(in), in);
  };
}

/// As `ask` says it of each item.
template <class Item, class Ask>
auto each(const std::vector<Item>& items, const Ask& ask) {
  std::vector<decltype(ask(items.front()))> answers;
  for (const Item& item : items) answers.push_back(ask(item));
  return answers;
}

std::vector<PublicFunction> solid_functions() {
  using scene::Solid;
  using Points = std::vector<Eigen::Vector3d>;
  const auto described = [](std::shared_ptr<const Solid> solid, const Input& in) {
    return [solid = std::move(solid), in] {
      return each(points_of(in), [&](const Eigen::Vector3d& p) { return solid->signed_distance(p); });
    };
  };
  return {
      gives("scene::Solid::Solid",
            [described](const Input& in) { return described(std::make_shared<const Solid>(tetrahedron_of(in)), in); }),
      gives("scene::Solid::Solid",
            [described](const Input& in) {
              const Mesh mesh{{in.triangle.a, in.triangle.b, in.triangle.c, in.point},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
              return described(std::make_shared<const Solid>(mesh), in);
            }),
      gives("scene::Solid::locate", of_solid([](const Solid& solid, const Points& points, const Input&) {
              return each(points, [&](const Eigen::Vector3d& p) { return solid.locate(p); });
            })),
      gives("scene::Solid::touches", of_solid([](const Solid& solid, const Points&, const Input& in) {
              return each(balls_of(in), [&](const Ball& ball) { return static_cast<int>(solid.touches(ball)); });
            })),
      gives("scene::Solid::signed_distance", of_solid([](const Solid& solid, const Points& points, const Input&) {
              return each(points, [&](const Eigen::Vector3d& p) { return solid.signed_distance(p); });
            })),
      gives("scene::Solid::locate", of_solid([](const Solid& solid, const Points& points, const Input&) {
              std::vector<PointLocation> answers(points.size());
              solid.locate(points, answers);
              return answers;
            })),
      gives("scene::Solid::touches", of_solid([](const Solid& solid, const Points&, const Input& in) {
              const std::vector<Ball> balls = balls_of(in);
              std::array<bool, 5> touches{};
              solid.touches(balls, touches);
              return touches;
            })),
      gives("scene::Solid::signed_distance", of_solid([](const Solid& solid, const Points& points, const Input&) {
              std::vector<double> answers(points.size());
              solid.signed_distance(points, answers);
              return answers;
            })),
  };
}

}  // namespace

std::vector<PublicFunction> scene_functions() {
  std::vector<PublicFunction> all = static_functions();
  for (PublicFunction& about_solid : solid_functions()) all.push_back(std::move(about_solid));
  for (PublicFunction& moving : moving_functions()) all.push_back(std::move(moving));
  return all;
}

}  // namespace touchstone::every_state_tests
