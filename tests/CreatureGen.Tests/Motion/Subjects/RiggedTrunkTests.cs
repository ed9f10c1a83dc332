using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Subjects;

/// <summary>Four-legged skeletons whose last joint of the trunk is in the middle of the back, far behind the shoulders that hang on it, as in many files of other programs.</summary>
public sealed class RiggedTrunkTests
{
    private const float Hips = 0.65f;

    [Theory]
    [InlineData(0f)]
    [InlineData(0.15f)]
    [InlineData(0.3f)]
    [InlineData(0.4f)]
    public void A_dog_sits_down_wherever_the_last_joint_of_its_trunk_is(float behind)
    {
        var body = new RiggedBody(Dog(behind));
        var profile = new MotionProfile(body.Subject);
        ActAbility sit = profile.Acts.Find("Sit");
        Assert.True(sit.IsPossible, sit.Refusal);
        Clip clip = ClipBaker.RecipesOf(profile).Single(recipe => recipe.Name == "Sit").Bake();
        (float rump, float shoulders) = (float.MaxValue, float.MaxValue);
        var pose = new Pose(new Quaternion[body.Subject.Skeleton.Count], new Vector3[body.Subject.Skeleton.Count]);
        for (int frame = 0; frame < clip.Frames; frame++)
        {
            clip.Sample(clip.TimeOf(frame), pose);
            ForwardKinematics.LocalToModel(body.Subject.Skeleton, pose, pose);
            rump = float.Min(rump, HipOf(body, pose, rear: true));
            shoulders = float.Min(shoulders, HipOf(body, pose, rear: false));
        }

        Assert.InRange(rump, 0f, 0.6f * Hips);
        Assert.InRange(shoulders, 0.8f * Hips, Hips);
    }

    private static float HipOf(RiggedBody body, in Pose pose, bool rear)
    {
        float height = 0f;
        foreach (var limb in body.Subject.Limbs.Where(limb => limb.Stands))
        {
            int hip = limb.Joints[1];
            height = body.Subject.Skeleton.ModelPositions[hip].Z < 0.2f == rear ? pose.Positions[hip].Y : height;
        }

        return height;
    }

    /// <summary>A dog whose shoulders are so far ahead of the joint that they hang on, metres.</summary>
    private static Skeleton Dog(float behind)
    {
        List<JointPlacement> joints = [Named("Bip01 Pelvis", -1, new(0f, 0.7f, -0.1f)), Named("Bip01 Spine", 0, new(0f, 0.05f, 0.55f - behind)), Named("Bip01 Neck", 1, new(0f, 0.15f, behind + 0.15f)), Named("Bip01 Head", 2, new(0f, 0.05f, 0.2f))];
        foreach ((string side, float x) in new[] { ("L", 0.12f), ("R", -0.12f) })
        {
            joints.AddRange([Named($"Bip01 {side} Thigh", 0, new(x, -0.05f, 0f)), Named($"Bip01 {side} Calf", joints.Count, new(0f, -0.3f, 0.05f)), Named($"Bip01 {side} Foot", joints.Count + 1, new(0f, -0.28f, -0.08f))]);
            joints.AddRange([Named($"Bip01 {side} UpperArm", 1, new(x, -0.1f, behind)), Named($"Bip01 {side} Forearm", joints.Count, new(0f, -0.3f, -0.06f)), Named($"Bip01 {side} Hand", joints.Count + 1, new(0f, -0.28f, 0.05f))]);
        }

        return Skeleton.Build(joints);

        static JointPlacement Named(string name, int parent, Vector3 at) => new(name, parent, Quaternion.Identity, at);
    }
}
