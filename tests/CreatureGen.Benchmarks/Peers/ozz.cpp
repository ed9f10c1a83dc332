// Times ozz-animation at the work of this library's poses, and at a frame of clips that stands beside an update.
#include <cmath>
#include <memory>

#include "ozz/animation/offline/animation_builder.h"
#include "ozz/animation/offline/raw_animation.h"
#include "ozz/animation/offline/raw_skeleton.h"
#include "ozz/animation/offline/skeleton_builder.h"
#include "ozz/animation/runtime/animation.h"
#include "ozz/animation/runtime/blending_job.h"
#include "ozz/animation/runtime/ik_aim_job.h"
#include "ozz/animation/runtime/ik_two_bone_job.h"
#include "ozz/animation/runtime/local_to_model_job.h"
#include "ozz/animation/runtime/sampling_job.h"
#include "ozz/animation/runtime/skeleton.h"
#include "ozz/base/containers/vector.h"
#include "ozz/base/maths/simd_math.h"
#include "ozz/base/maths/simd_quaternion.h"
#include "ozz/base/maths/soa_transform.h"
#include "ozz/geometry/runtime/skinning_job.h"
#include "subject.h"

namespace {

using ozz::animation::Animation;
using ozz::animation::Skeleton;
using ozz::math::Float4x4;
using ozz::math::SoaTransform;

const int kRepeats = 200;

// Creatures of the crowd, and how many of them are timed together, as in the probe.
const int kCrowd = 512;
const int kBlock = 8;

const int kKeysPerSecond = 30;
const int kLegs = 4;

std::vector<Subject> subjects;

ozz::math::Transform At(const std::vector<float>& pose, size_t joint) {
  const float* p = &pose[joint * 7];
  return {{p[0], p[1], p[2]}, {p[3], p[4], p[5], p[6]}, {1.f, 1.f, 1.f}};
}

void AddChildren(const Subject& s, int parent, ozz::animation::offline::RawSkeleton::Joint::Children* into, std::vector<int>* order) {
  for (size_t i = 0; i < s.Joints(); i++) {
    if (s.parents[i] != parent) continue;
    into->emplace_back();
    into->back().name = std::to_string(i).c_str();
    into->back().transform = At(s.first, i);
  }
  for (auto& child : *into) AddChildren(s, std::stoi(child.name.c_str()), &child.children, order);
}

// A creature's skeleton and two clips of a second between its two poses.
struct Puppet {
  ozz::unique_ptr<Skeleton> skeleton;
  ozz::unique_ptr<Animation> clips[2];
  ozz::animation::SamplingJob::Context contexts[2];
  ozz::vector<SoaTransform> samples[2], blended;
  ozz::vector<Float4x4> models, matrices;
  float time = 0.f;

  explicit Puppet(const Subject& s) {
    ozz::animation::offline::RawSkeleton raw;
    AddChildren(s, -1, &raw.roots, nullptr);
    skeleton = ozz::animation::offline::SkeletonBuilder()(raw);
    if (!skeleton) throw std::runtime_error("a skeleton is not valid");
    for (int c = 0; c < 2; c++) {
      ozz::animation::offline::RawAnimation clip;
      clip.duration = 1.f;
      clip.tracks.resize(skeleton->num_joints());
      for (int i = 0; i < skeleton->num_joints(); i++) {
        const size_t joint = std::stoul(skeleton->joint_names()[i]);
        const auto first = At(s.first, joint), second = At(s.second, joint);
        auto& track = clip.tracks[i];
        track.translations.push_back({0.f, first.translation});
        track.scales.push_back({0.f, ozz::math::Float3::one()});
        for (int k = 0; k <= kKeysPerSecond; k++) {
          const float t = static_cast<float>(k) / kKeysPerSecond;
          track.rotations.push_back({t, NLerp(first.rotation, second.rotation, 0.5f + 0.5f * std::sin(6.2831853f * t + c))});
        }
      }
      clips[c] = ozz::animation::offline::AnimationBuilder()(clip);
      if (!clips[c]) throw std::runtime_error("a clip is not valid");
      contexts[c].Resize(skeleton->num_joints());
      samples[c].resize(skeleton->num_soa_joints());
    }
    blended.resize(skeleton->num_soa_joints());
    models.resize(skeleton->num_joints());
    matrices.resize(skeleton->num_joints());
    Sample(0);
    Sample(1);
    Blend();
    Chain();
  }

  void Sample(int clip) {
    ozz::animation::SamplingJob job;
    job.animation = clips[clip].get();
    job.context = &contexts[clip];
    job.ratio = time;
    job.output = make_span(samples[clip]);
    Run(job);
  }

  void Blend() {
    ozz::animation::BlendingJob::Layer layers[2];
    for (int i = 0; i < 2; i++) {
      layers[i].transform = make_span(samples[i]);
      layers[i].weight = i == 0 ? 0.3f : 0.7f;
    }
    ozz::animation::BlendingJob job;
    job.layers = layers;
    job.rest_pose = skeleton->joint_rest_poses();
    job.output = make_span(blended);
    Run(job);
  }

  void Chain() {
    ozz::animation::LocalToModelJob job;
    job.skeleton = skeleton.get();
    job.input = make_span(blended);
    job.output = make_span(models);
    Run(job);
  }

  void Legs() {
    const int joints = skeleton->num_joints();
    for (int leg = 0; leg < kLegs; leg++) {
      ozz::math::SimdQuaternion start, middle;
      ozz::animation::IKTwoBoneJob job;
      const int hip = (leg * 3 + 1) % (joints - 3);
      job.start_joint = &models[hip];
      job.mid_joint = &models[hip + 1];
      job.end_joint = &models[hip + 2];
      job.target = models[hip + 2].cols[3];
      job.start_joint_correction = &start;
      job.mid_joint_correction = &middle;
      Run(job);
      Turn(hip, start);
      Turn(hip + 1, middle);
    }
    ozz::math::SimdQuaternion gaze;
    ozz::animation::IKAimJob aim;
    aim.joint = &models[joints / 2];
    aim.target = ozz::math::simd_float4::Load(1.f, 1.f, 5.f, 0.f);
    aim.joint_correction = &gaze;
    Run(aim);
    Turn(joints / 2, gaze);
  }

  // The palette of the skin.
  void Palette(const Subject& s) {
    for (size_t i = 0; i < matrices.size(); i++) {
      const float* m = &s.matrices[i * 16];
      Float4x4 bind;
      for (int c = 0; c < 4; c++) bind.cols[c] = ozz::math::simd_float4::LoadPtrU(m + 4 * c);
      matrices[i] = models[i] * bind;
    }
  }

  void Frame(const Subject& s, float dt) {
    time = std::fmod(time + dt, 1.f);
    Sample(0);
    Sample(1);
    Blend();
    Chain();
    Legs();
    Chain();
    Palette(s);
  }

 private:
  template <class Job>
  static void Run(const Job& job) {
    if (!job.Run()) throw std::runtime_error("a job is not valid");
  }

  // Multiplies a local rotation of four joints side by side.
  void Turn(int joint, const ozz::math::SimdQuaternion& by) {
    SoaTransform& four = blended[joint / 4];
    ozz::math::SimdFloat4 aos[4];
    ozz::math::Transpose4x4(&four.rotation.x, aos);
    ozz::math::SimdQuaternion q = {aos[joint & 3]};
    aos[joint & 3] = (q * by).xyzw;
    ozz::math::Transpose4x4(aos, &four.rotation.x);
  }
};

struct Skin {
  const Subject& s;
  ozz::vector<Float4x4> matrices;
  std::vector<float> positions, normals;

  explicit Skin(const Subject& subject) : s(subject), positions(s.positions.size()), normals(s.normals.size()) {
    matrices.resize(s.Joints());
    for (size_t i = 0; i < matrices.size(); i++)
      for (int c = 0; c < 4; c++) matrices[i].cols[c] = ozz::math::simd_float4::LoadPtrU(&s.matrices[i * 16 + 4 * c]);
  }

  void Do() {
    ozz::geometry::SkinningJob job;
    job.vertex_count = static_cast<int>(s.Vertices());
    job.influences_count = 4;
    job.joint_matrices = make_span(matrices);
    job.joint_indices = {s.joints.data(), s.joints.size()};
    job.joint_indices_stride = sizeof(uint16_t) * 4;
    job.joint_weights = {s.weights.data(), s.weights.size()};
    job.joint_weights_stride = sizeof(float) * 3;
    job.in_positions = {s.positions.data(), s.positions.size()};
    job.in_normals = {s.normals.data(), s.normals.size()};
    job.out_positions = {positions.data(), positions.size()};
    job.out_normals = {normals.data(), normals.size()};
    job.in_positions_stride = job.in_normals_stride = job.out_positions_stride = job.out_normals_stride = sizeof(float) * 3;
    if (!job.Run()) throw std::runtime_error("the skinning is not valid");
  }
};

Row Each(const std::function<std::function<void()>(const Subject&)>& work) {
  Row row;
  row.operations = kRepeats;
  for (const Subject& s : subjects) {
    auto once = work(s);
    row.items.push_back([once] {
      for (int i = 0; i < kRepeats; i++) once();
    });
  }
  return row;
}

Row TwoBones() {
  return Each([](const Subject& s) -> std::function<void()> {
    auto puppet = std::make_shared<Puppet>(s);
    return [puppet] {
      ozz::math::SimdQuaternion start, middle;
      ozz::animation::IKTwoBoneJob job;
      job.start_joint = &puppet->models[1];
      job.mid_joint = &puppet->models[2];
      job.end_joint = &puppet->models[3];
      job.target = puppet->models[3].cols[3] + ozz::math::simd_float4::Load(0.01f, 0.02f, 0.f, 0.f);
      job.soften = 0.97f;
      job.start_joint_correction = &start;
      job.mid_joint_correction = &middle;
      if (!job.Run()) throw std::runtime_error("the limb is not valid");
    };
  });
}

Row March() {
  auto puppets = std::make_shared<std::vector<std::unique_ptr<Puppet>>>();
  for (int i = 0; i < kCrowd; i++) puppets->push_back(std::make_unique<Puppet>(subjects[i % subjects.size()]));
  Row row;
  row.operations = kBlock;
  for (int block = 0; block < kCrowd / kBlock; block++)
    row.items.push_back([puppets, block] {
      for (int i = block * kBlock; i < (block + 1) * kBlock; i++) (*puppets)[i]->Frame(subjects[i % subjects.size()], 1.f / 60.f);
    });
  return row;
}

Row Make(const std::string& name) {
  if (name == "blend" || name == "chain")
    return Each([&](const Subject& s) -> std::function<void()> {
      auto puppet = std::make_shared<Puppet>(s);
      if (name == "blend") return [puppet] { puppet->Blend(); };
      return [puppet] { puppet->Chain(); };
    });
  if (name == "twobone") return TwoBones();
  if (name == "walk") return March();
  if (name == "skinning") {
    Row row;
    for (const Subject& s : subjects) {
      auto skin = std::make_shared<Skin>(s);
      row.items.push_back([skin] { skin->Do(); });
    }
    return row;
  }
  throw std::invalid_argument("no row '" + name + "'");
}

}  // namespace

int main() {
  return Obey([](const std::string& folder) { subjects = Subject::ReadAll(folder); }, Make);
}
