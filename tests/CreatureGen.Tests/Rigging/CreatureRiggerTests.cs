using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class CreatureRiggerTests
{
    private const float Metres = 1e-5f;

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_root_lies_on_the_ground_and_the_body_on_the_spine_both_unturned(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Joint root = subject.Skeleton.Joints[0];
        Assert.Equal(("Root", JointRole.Root, -1), (root.Name, root.Role, root.Parent));
        Assert.Equal((Vector3.Zero, Quaternion.Identity), (root.ModelPosition, root.ModelRotation));
        Joint body = subject.Skeleton.Joints[1];
        Assert.Equal(("Body", JointRole.Body, 0), (body.Name, body.Role, body.Parent));
        Assert.Equal(Quaternion.Identity, body.ModelRotation);
        if (subject.Input.Blueprint.Kind == LocomotionKind.Swimming)
        {
            Near(subject.Rig.Line.At(20), body.ModelPosition);
        }
        else
        {
            double Arc(string name) => ArcOf(subject, subject.Joint(name).ModelPosition);
            Assert.Equal((Arc("Pelvis") + Arc("Chest")) / 2, ArcOf(subject, body.ModelPosition), 4);
        }
    }

    /// <summary>They hung on the head, a body's length away, and swung with it.</summary>
    [Theory]
    [InlineData(12500085UL)]
    [InlineData(12500110UL, Explicit = true)]
    public void Feelers_at_the_rear_hang_on_the_rear(ulong seed)
    {
        Skeleton skeleton = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }).Skeleton;
        Joint[] roots = skeleton.Joints.Where(joint => joint.Role == JointRole.Antenna && skeleton.Joints[joint.Parent].Role != JointRole.Antenna).ToArray();
        Assert.Contains(roots, root => root.ModelPosition.Z < 0f);
        Assert.All(roots, root => Assert.Equal(root.ModelPosition.Z > 0f, skeleton.Joints[root.Parent].Role == JointRole.Head));
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Local_y_points_along_every_bone_at_its_main_child(BodyPlan plan)
    {
        Skeleton skeleton = RigSubject.Of(plan).Skeleton;
        int bones = 0;
        for (int j = 2; j < skeleton.Count; j++)
        {
            Joint joint = skeleton.Joints[j];
            if (joint.Role == JointRole.End)
            {
                Assert.Equal(0f, joint.Length);
                continue;
            }

            Vector3 end = joint.ModelPosition + (Rotation.Rotate(joint.ModelRotation, Vector3.UnitY) * joint.Length);
            Assert.True(joint.Length > 1e-4f, $"{joint.Name} has length {joint.Length}");
            Assert.True(Children(skeleton, j).Any(c => Vec.Distance(skeleton.Joints[c].ModelPosition, end) < Metres), $"{joint.Name} points at none of its children");
            bones++;
        }

        Assert.InRange(bones, 15, 120);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_leaves_are_the_end_joints(BodyPlan plan)
    {
        Skeleton skeleton = RigSubject.Of(plan).Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            Assert.Equal(skeleton.Joints[j].Role == JointRole.End, !Children(skeleton, j).Any());
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_right_is_the_exact_mirror_image_of_the_left(BodyPlan plan)
    {
        Skeleton skeleton = RigSubject.Of(plan).Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            Joint joint = skeleton.Joints[j];
            Joint mirror = skeleton.Joints[skeleton.Mirrors[j]];
            Assert.Equal(joint.Side == Side.Median, mirror == joint);
            Assert.Equal(Vec.Mirror(joint.ModelPosition), mirror.ModelPosition);
            Assert.Equal(Vec.Mirror(joint.LocalPosition), mirror.LocalPosition);
            Assert.Equal(Rotation.Mirror(joint.ModelRotation), mirror.ModelRotation);
            Assert.Equal(Rotation.Mirror(joint.LocalRotation), mirror.LocalRotation);
            Assert.Equal(joint.Limit.Mirrored(), mirror.Limit);
            Assert.Equal(joint.Length, mirror.Length);
            Assert.Equal(joint.Side == Side.Left, joint.Side != Side.Median && joint.ModelPosition.X > 0f);
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Hinges_of_spine_and_feet_turn_about_the_left_axis(BodyPlan plan)
    {
        Skeleton skeleton = RigSubject.Of(plan).Skeleton;
        foreach (Joint joint in skeleton.Joints)
        {
            Rotation.ToBasis(joint.ModelRotation, out Vector3 x, out _, out _);
            if (joint.Side == Side.Median)
            {
                Assert.Equal(Vector3.UnitX, x);
            }
        }

        foreach (LimbChain limb in RigSubject.Of(plan).Rig.Limbs)
        {
            if (limb.Kind != LimbKind.Leg)
            {
                continue;
            }

            bool lateral = limb.Archetype is LimbArchetype.Insect or LimbArchetype.Sprawl;
            Rotation.ToBasis(skeleton.ModelRotations[limb.Joints[2]], out Vector3 x, out _, out _);

            // The knee of a leg out to the side bends in the upright plane that the leg lies in; that of a swimmer's leg, laid back along its flank, in a plane that is rather level.
            bool trails = limb.Archetype == LimbArchetype.Sprawl && RigSubject.BlueprintOf(plan).Kind == LocomotionKind.Swimming;
            Vector3 reach = skeleton.ModelPositions[limb.Joints[3]] - skeleton.ModelPositions[limb.Joints[1]];
            Vector3 ofSide = trails ? -Vector3.UnitY * (limb.Side == Side.Left ? 1f : -1f) : Vec.Normalize(new Vector3(-reach.Z, 0f, reach.X));
            Vector3 axis = lateral ? ofSide : Vector3.UnitX;
            Assert.True(Vec.Dot(x, axis) > 0.6f, $"the knee of {limb.Archetype} {limb.Pair} turns about {x}");
        }
    }

    [Fact]
    public void A_dog_has_the_joints_of_a_dog()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Digitigrade);
        string[] names = subject.Skeleton.Joints.Select(j => j.Name).ToArray();
        string[] expected =
        {
            "Root", "Body", "Pelvis", "Spine_01", "Spine_02", "Chest", "Neck_01", "Neck_02", "Neck_03", "Head", "HeadEnd", "Jaw", "JawEnd", "Eye_L", "Eye_L_End", "Eye_R", "Eye_R_End",
            "Tail_01", "Tail_02", "Tail_03", "TailEnd",
            "Leg_L1_Girdle", "Leg_L1_Hip", "Leg_L1_Knee", "Leg_L1_Ankle", "Leg_L1_Ball", "Leg_L1_End", "Leg_R1_Girdle", "Leg_R1_Hip", "Leg_L2_Girdle", "Leg_R2_End",
        };
        Assert.All(expected, n => Assert.Contains(n, names));
        string ParentOf(string joint) => subject.Skeleton.Joints[subject.Joint(joint).Parent].Name;
        Assert.Equal("Chest", ParentOf("Leg_L1_Girdle"));
        Assert.Equal("Pelvis", ParentOf("Leg_R2_Girdle"));
        Assert.Equal("Pelvis", ParentOf("Tail_01"));
        Assert.Equal("Body", ParentOf("Pelvis"));
        Assert.Equal("Head", ParentOf("Jaw"));
        Assert.Equal("Head", ParentOf("Eye_R"));
    }

    [Fact]
    public void A_flier_carries_its_wings_on_the_chest_and_a_swimmer_its_spine_behind_the_root()
    {
        RigSubject flier = RigSubject.Of(BodyPlan.Flapping);
        Assert.Equal("Chest", flier.Skeleton.Joints[flier.Joint("Wing_L1_1").Parent].Name);
        Assert.Equal("Wing_R1_4", flier.Skeleton.Joints[flier.Joint("Wing_R1_End").Parent].Name);

        RigSubject eel = RigSubject.Of(BodyPlan.Eel);
        Assert.Equal("Body", eel.Skeleton.Joints[eel.Joint("Spine_01").Parent].Name);
        Assert.Equal("Body", eel.Skeleton.Joints[eel.Joint("Head").Parent].Name);
        Assert.True(eel.Skeleton.IndexOf("Spine_18") > 0);
        Assert.Equal(-1, eel.Skeleton.IndexOf("Pelvis"));
        RigSubject fish = RigSubject.Of(BodyPlan.Fish);
        Assert.True(fish.Skeleton.IndexOf("Spine_08") > 0);
        Assert.Equal(-1, fish.Skeleton.IndexOf("Spine_17"));
        Assert.Equal(JointRole.End, fish.Joint("TailEnd").Role);
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void A_larger_body_has_more_spine_bones(BodyPlan plan)
    {
        CreatureBlueprint blueprint = RigSubject.BlueprintOf(plan);
        int before = 0;
        int first = 0;
        foreach (double scale in new[] { 0.3, 0.5, 0.8, 1.2, 2.0, 3.0 })
        {
            Rig rig = CreatureRigger.Build(RigSubject.InputOf(blueprint with { Scale = scale }));
            int count = rig.Skeleton.Joints.Count(j => j.Role == JointRole.Spine);
            Assert.True(count >= before);
            first = before == 0 ? count : first;
            before = count;
        }

        Assert.True(before > first);
        Assert.True(plan != BodyPlan.Legless || first >= 6);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Limb_chains_run_from_girdle_to_end_with_the_lengths_of_their_bones(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Skeleton skeleton = subject.Skeleton;
        Assert.Equal(subject.Input.Appendages.Sum(a => a.Paired ? 2 : 1), subject.Rig.Limbs.Count);
        foreach (LimbChain limb in subject.Rig.Limbs)
        {
            Assert.Equal(limb.Joints.Count - 1, limb.RestLengths.Count);
            for (int k = 1; k < limb.Joints.Count; k++)
            {
                Assert.Equal(limb.Joints[k - 1], skeleton.Parents[limb.Joints[k]]);
                Assert.Equal(Vec.Distance(skeleton.ModelPositions[limb.Joints[k - 1]], skeleton.ModelPositions[limb.Joints[k]]), limb.RestLengths[k - 1], 1e-6f);
            }

            Assert.Equal(1f, Vec.Length(limb.Pole), 1e-4f);
            if (limb.Kind is LimbKind.Leg or LimbKind.Arm)
            {
                JointRole[] roles = limb.Joints.Select(j => skeleton.Joints[j].Role).ToArray();
                Assert.Equal(new[] { JointRole.Girdle, JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball, JointRole.End }, roles);
                Assert.True(!limb.Stands || Math.Abs(limb.Contact.Y) < 1e-4f);

                // The girdle lies level with the hip, on the side of the spine.
                Vector3 girdle = skeleton.ModelPositions[limb.Joints[0]];
                Vector3 hip = skeleton.ModelPositions[limb.Joints[1]];
                Near(new Vector3(hip.X / 2f, hip.Y, hip.Z), girdle);
            }

            if (limb.Side == Side.Left)
            {
                LimbChain right = subject.Rig.Limbs.Single(l => l.Kind == limb.Kind && l.Pair == limb.Pair && l.Side == Side.Right);
                Assert.Equal(Vec.Mirror(limb.Pole), right.Pole);
                Assert.Equal(Vec.Mirror(limb.Contact), right.Contact);
            }
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Every_bone_of_the_spine_has_a_place_on_top_and_on_both_sides(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        IReadOnlyList<AttachmentPoint> points = subject.Rig.AttachmentPoints;
        Assert.Equal(3 * subject.Rig.Spine.Joints.Length, points.Count);
        Assert.Equal(points.Count, points.Select(p => p.Name).Distinct().Count());
        for (int i = 0; i < points.Count; i += 3)
        {
            AttachmentPoint top = points[i];
            AttachmentPoint left = points[i + 1];
            AttachmentPoint right = points[i + 2];
            Assert.Equal(subject.Skeleton.Joints[top.Joint].Name + "_Top", top.Name);
            Assert.Equal(0f, top.Position.X);
            Assert.Equal(Vec.Mirror(left.Position), right.Position);
            Assert.Equal(left.Position.X - right.Position.X, left.Width);
            Assert.True(left.Normal.X > 0.3f, $"{left.Name} looks to {left.Normal}");
            Assert.True(left.Width > 0f);
            foreach (AttachmentPoint p in new[] { top, left, right })
            {
                Assert.Equal(1f, Vec.Length(p.Normal), 1e-4f);

                // Outward: a step along the normal leads away from the spine.
                Vector3 centre = subject.Rig.Line.At(subject.Rig.Line.RingAt(ArcOf(subject, p.Position with { X = 0f })));
                Assert.True(Vec.Distance(p.Position + (p.Normal * 0.01f), centre) > Vec.Distance(p.Position, centre), p.Name);
            }
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_bodys_capsule_lies_around_the_trunk_above_the_ground(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        CapsuleCollider body = subject.Rig.Body;
        Assert.Equal(0, body.Joint);
        Assert.Equal(0f, body.Start.X);
        Assert.True(body.Radius > 0.02f && body.Radius < 1f);
        FinishedRig finished = subject.Rig.Scaled(1f);
        Assert.Equal(subject.Joint("Body").ModelPosition.Y, finished.StandingHeight);
        Assert.True(subject.Input.Blueprint.Kind != LocomotionKind.Walking || finished.StandingHeight > 0f);
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void A_scaled_rig_is_the_same_rig_in_other_units(BodyPlan plan)
    {
        const float Factor = 1.7f;
        RigSubject subject = RigSubject.Of(plan);
        FinishedRig scaled = subject.Rig.Scaled(Factor);
        for (int j = 0; j < subject.Skeleton.Count; j++)
        {
            Joint before = subject.Skeleton.Joints[j];
            Joint after = scaled.Skeleton.Joints[j];
            Assert.Equal(before.Name, after.Name);
            Assert.Equal(before.ModelRotation, after.ModelRotation);
            Near(before.ModelPosition * Factor, after.ModelPosition);
            Assert.Equal(before.Length * Factor, after.Length);
        }

        Assert.Equal(subject.Rig.Body.Radius * Factor, scaled.Body.Radius);
        Assert.Equal(subject.Rig.AttachmentPoints[0].Width * Factor, scaled.AttachmentPoints[0].Width);
        if (scaled.Limbs.Count > 0)
        {
            Assert.Equal(subject.Rig.Limbs[0].RestLengths[1] * Factor, scaled.Limbs[0].RestLengths[1]);
            Assert.Equal(subject.Rig.Limbs[0].Contact * Factor, scaled.Limbs[0].Contact);
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Limits_hold_the_rest_pose_and_knees_bend_one_way(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        foreach (Joint joint in subject.Skeleton.Joints)
        {
            foreach (AngleRange range in new[] { joint.Limit.SwingX, joint.Limit.SwingZ, joint.Limit.Twist })
            {
                Assert.True(range.Min <= 0f && range.Max >= 0f && range.Max - range.Min <= 6.2832f, joint.Name);
            }

            Assert.True(joint.Role is not (JointRole.Girdle or JointRole.End) || joint.Limit == JointLimit.Fixed);
        }

        foreach (LimbChain limb in subject.Rig.Limbs.Where(l => l.Kind == LimbKind.Leg && l.Archetype is not (LimbArchetype.Insect or LimbArchetype.Sprawl)))
        {
            Joint knee = subject.Skeleton.Joints[limb.Joints[2]];
            float fold = limb.Pole.Z > 0f ? knee.Limit.SwingX.Max : -knee.Limit.SwingX.Min;
            float back = limb.Pole.Z > 0f ? -knee.Limit.SwingX.Min : knee.Limit.SwingX.Max;
            Assert.True(fold > 2f * back, $"the knee of {limb.Archetype} folds {fold} and over-straightens {back}");
        }
    }

    [Fact]
    public void A_limb_with_too_few_points_is_refused()
    {
        var leg = new Appendage { Kind = LimbKind.Leg, Pair = 2, Paired = true, Archetype = LimbArchetype.Column, Joints = new Vector3[3] };
        ArgumentException error = Assert.Throws<ArgumentException>(() => LimbRigger.Add(new SkeletonBuilder(), leg, 0));
        Assert.Contains("Leg 2 has 3 joint points; expected 5", error.Message, StringComparison.Ordinal);
    }

    private static IEnumerable<int> Children(Skeleton skeleton, int joint) => Enumerable.Range(0, skeleton.Count).Where(c => skeleton.Joints[c].Parent == joint);

    /// <summary>Arc length of the spine's place nearest to a point.</summary>
    private static double ArcOf(RigSubject subject, Vector3 p)
    {
        double best = 0;
        float min = float.MaxValue;
        for (int i = 0; i < BodyGrid.Rings - 1; i++)
        {
            Vector3 a = subject.Rig.Line.At(i);
            Vector3 d = subject.Rig.Line.At(i + 1) - a;
            float t = Scalar.Clamp(Vec.Dot(p - a, d) / Vec.LengthSquared(d), 0f, 1f);
            float distance = Vec.Distance(p, a + (d * t));
            if (distance < min)
            {
                min = distance;
                best = subject.Rig.Line.ArcAt(i + (double)t);
            }
        }

        return best;
    }

    private static void Near(Vector3 expected, Vector3 actual) => Assert.True(Vec.Distance(expected, actual) < Metres, $"expected {expected}, found {actual}");
}
