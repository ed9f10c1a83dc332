using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Gaze;

public sealed class EyelidsTests
{
    private static readonly string[] names = { "UpperLid_L", "UpperLid_R", "LowerLid_L", "LowerLid_R" };

    [Fact]
    public void Eyes_with_an_iris_have_four_lids_below_the_head_or_none_and_all_others_none()
    {
        int lidded = 0;
        foreach (LocomotionKind kind in Enum.GetValues<LocomotionKind>())
        {
            for (ulong seed = 0; seed < (ulong)Thoroughness.Of(40); seed++)
            {
                Creature creature = Generate(kind, seed);
                string[] lids = creature.Skeleton.Joints.Where(joint => joint.Role == JointRole.Lid).Select(joint => joint.Name).ToArray();
                bool blinks = creature.Blueprint.Head.Eyes.Style is EyeStyle.Round or EyeStyle.Slit or EyeStyle.Bar && lids.Length > 0;
                Assert.True(lids.Length == 0 || blinks);
                Assert.Equal(lids.Length == 0, Eyelids.Of(creature.Skeleton) == null);
                if (blinks)
                {
                    lidded++;
                    string[] heads = creature.Blueprint.Fork == null ? [""] : ["", Heads.Suffix];
                    Assert.Equal(heads.SelectMany(head => names.Select(name => name + head)).Order(StringComparer.Ordinal), lids.Order(StringComparer.Ordinal));
                    foreach (string head in heads)
                    {
                        Assert.All(names, name => Assert.Equal("Head" + head, creature.Skeleton.Joints[creature.Skeleton.Joints[creature.Skeleton.IndexOf(name + head)].Parent].Name));
                        Assert.All(names, name => Assert.Equal(creature.Skeleton.IndexOf(name + head), creature.Skeleton.Joints[creature.Skeleton.IndexOf(name + "_End" + head)].Parent));
                    }
                }
            }
        }

        Assert.InRange(lidded, Thoroughness.Of(45), Thoroughness.Of(120) - 1);
    }

    [Fact]
    public void Fish_and_snakes_never_blink_and_wear_a_rim_that_stays_with_the_head()
    {
        foreach ((string body, RequestedKind kind) in new[] { ("fish", RequestedKind.Swimming), ("serpent", RequestedKind.Walking), ("cobra", RequestedKind.Walking), ("shark", RequestedKind.Swimming), ("eel", RequestedKind.Swimming) })
        {
            for (ulong seed = 0; seed < 4; seed++)
            {
                Creature creature = SpeciesSubject.Of(body, kind, seed);
                Assert.Null(Eyelids.Of(creature.Skeleton));
                Assert.DoesNotContain(creature.Skeleton.Joints, joint => joint.Role == JointRole.Lid);
            }
        }
    }

    [Theory]
    [InlineData("canine", RequestedKind.Walking)]
    [InlineData("feline", RequestedKind.Walking)]
    [InlineData("owl", RequestedKind.Flying)]
    [InlineData("seal", RequestedKind.Swimming)]
    public void Shut_lids_lie_before_the_pupil_and_left_and_right_stay_mirror_images(string body, RequestedKind kind)
    {
        Creature creature = SpeciesSubject.Of(body, kind);
        Assert.False(IsCovered(creature, Pose(creature, 0f)));
        Vector3[] shut = Pose(creature, 1f);
        Assert.True(IsCovered(creature, shut));
        Skeleton skeleton = creature.Skeleton;
        var left = new List<Vector3>();
        var right = new List<Vector3>();
        for (int v = 0; v < shut.Length; v++)
        {
            Joint joint = skeleton.Joints[creature.Mesh.Weights[v].Joint0];
            if (joint.Role == JointRole.Lid)
            {
                (joint.Side == Side.Left ? left : right).Add(shut[v]);
            }
        }

        Assert.Equal(left.Count, right.Count);
        Assert.All(left.Zip(right), pair => Assert.True(Vector3.Distance(Vec.Mirror(pair.First), pair.Second) < 1e-4f * creature.StandingHeight));
    }

    [Fact]
    public void A_creature_blinks_by_itself_within_the_limits_of_its_lids()
    {
        Creature creature = SpeciesSubject.Of("canine", RequestedKind.Walking);
        var animator = new CreatureAnimator(creature);
        int upper = creature.Skeleton.IndexOf("UpperLid_L");
        int blinks = 0;
        bool shut = false;
        for (int frame = 0; frame < 60 * 60; frame++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            float turn = Turn(creature.Skeleton.Joints[upper], animator.LocalPose.Rotations[upper]);
            Assert.InRange(turn, 0f, creature.Skeleton.Joints[upper].Limit.SwingX.Max + 1e-4f);
            bool now = turn > 0.9f * creature.Skeleton.Joints[upper].Limit.SwingX.Max;
            blinks += now && !shut ? 1 : 0;
            shut = now;
        }

        Assert.InRange(blinks, 5, 35);
    }

    [Fact]
    public void The_idle_clip_blinks_once_and_no_other_clip_does()
    {
        Creature creature = SpeciesSubject.Of("canine", RequestedKind.Walking);
        int upper = creature.Skeleton.IndexOf("UpperLid_L");
        foreach (Clip clip in ClipBaker.Bake(creature))
        {
            float max = 0f;
            for (int frame = 0; frame < clip.Frames; frame++)
            {
                max = Math.Max(max, Turn(creature.Skeleton.Joints[upper], clip.RotationsAt(frame)[upper]));
            }

            Assert.Equal(clip.Name == "Idle", max > 0.8f * creature.Skeleton.Joints[upper].Limit.SwingX.Max);
            Assert.True(clip.Name == "Idle" || max < 1e-3f);
        }
    }

    [Fact]
    public void Lids_are_kept_within_their_limits_and_refuse_what_is_no_number()
    {
        Creature creature = SpeciesSubject.Of("canine", RequestedKind.Walking);
        Joint lid = creature.Skeleton.Joints[creature.Skeleton.IndexOf("UpperLid_L")];
        Assert.Equal(Pose(creature, 1f), Pose(creature, 7f));
        Assert.NotEqual(Pose(creature, 0f), Pose(creature, -0.1f));
        Assert.True(lid.Limit.SwingX.Min < 0f);
        Assert.Throws<ArgumentException>(() => Pose(creature, float.NaN));
    }

    private static Creature Generate(LocomotionKind kind, ulong seed) => CreatureGenerator.Build(BlueprintSampler.Sample(seed, kind));

    private static float Turn(Joint joint, Quaternion local)
    {
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), local);
        return 2f * MathF.Atan2(turn.X, turn.W);
    }

    private static Vector3[] Pose(Creature creature, float shut)
    {
        Skeleton skeleton = creature.Skeleton;
        var rotations = new Quaternion[2][] { new Quaternion[skeleton.Count], new Quaternion[skeleton.Count] };
        var positions = new Vector3[2][] { new Vector3[skeleton.Count], new Vector3[skeleton.Count] };
        var local = new Pose(rotations[0], positions[0]);
        var model = new Pose(rotations[1], positions[1]);
        local.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, local, model);
        Eyelids.Of(skeleton)!.Close(shut, local, model);
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, model, matrices);
        var posed = new Vector3[creature.Mesh.Positions.Length];
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, posed, new Vector3[posed.Length]);
        return posed;
    }

    /// <summary>Whether a lid lies on the line of the left eye's gaze.</summary>
    private static bool IsCovered(Creature creature, Vector3[] posed)
    {
        Skeleton skeleton = creature.Skeleton;
        int eye = skeleton.IndexOf("Eye_L");
        Vector3 centre = skeleton.ModelPositions[eye];
        Vector3 gaze = Rotation.Rotate(skeleton.ModelRotations[eye], Vector3.UnitY);
        ReadOnlySpan<int> triangles = creature.Mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            bool lid = skeleton.Joints[creature.Mesh.Weights[triangles[t]].Joint0].Role == JointRole.Lid;
            if (lid && Features.RayCast.Hit(centre, gaze, posed[triangles[t]], posed[triangles[t + 1]], posed[triangles[t + 2]], out float distance, out _, out _) && distance > skeleton.Joints[eye].Length)
            {
                return true;
            }
        }

        return false;
    }
}
