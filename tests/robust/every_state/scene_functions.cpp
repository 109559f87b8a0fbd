// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "tests/robust/every_state/public_function.h"

namespace touchstone::every_state_tests {
namespace {

using scene::Scene;

scene::Faces faces_of(const Input& in) { return {{in.triangle}, {in.polygon}}; }

std::vector<Ball> balls_of(const Input& in) {
  return {in.ball, {in.ball.center, -0.0}, {in.point, 0}, {in.triangle.b, 0}, {in.polygon.vertex(2), -0.0}};
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
              scene->add("object", faces_of(in));
              try {
                scene->set_pose(0, in.any_pose);
              } catch (const Rejected&) {  // then it stays where it was
              }
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
              const std::vector<Ball> balls = balls_of(in);
              std::array<bool, 5> touches{};
              scene.touches(balls, touches);
              return touches;
            })),
      gives("scene::Scene::touched",
            of_scene([](const Scene& scene, const Input& in) { return scene.touched(balls_of(in)); })),
      gives("scene::Scene::nearest",
            of_scene([](const Scene& scene, const Input& in) { return scene.nearest(balls_of(in)); })),
  };
}

}  // namespace

std::vector<PublicFunction> scene_functions() {
  std::vector<PublicFunction> all = static_functions();
  for (PublicFunction& moving : moving_functions()) all.push_back(std::move(moving));
  return all;
}

}  // namespace touchstone::every_state_tests
