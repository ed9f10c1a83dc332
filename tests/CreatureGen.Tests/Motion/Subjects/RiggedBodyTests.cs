using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Subjects;

public sealed class RiggedBodyTests
{
    private static readonly FlatGround ground = new(Vector3.Zero, Vector3.UnitY);

    [Fact]
    public void A_person_of_another_program_walks_with_its_feet_where_those_of_its_stand_in_are()
    {
        var walk = new Walk(new RiggedBody(Person(0f)));
        for (int i = 0; i < 300; i++)
        {
            walk.Step(1.3f);
            walk.AssertFeetFollow(1e-4f);
        }

        Assert.InRange(walk.Animator.Root.Position.Z, 5f, 7f);
        Assert.Equal(BodyPlan.Upright, walk.Body.Subject.Plan);
    }

    /// <summary>What a foot that stands moves over the ground, in the world: the bones are as long as the stand-in's, so that none of it comes from bringing the pose over.</summary>
    [Fact]
    public void A_foot_that_stands_does_not_slide()
    {
        var walk = new Walk(new RiggedBody(Person(0f)));
        int toe = walk.Body.Skeleton.IndexOf("mixamorig:LeftToeBase");
        var places = new List<Vector3>();
        for (int i = 0; i < 400; i++)
        {
            walk.Step(1.2f);
            places.Add(walk.Animator.Root.ToWorld(walk.Model.Positions[toe] - new Vector3(0f, walk.Body.Ground, 0f)));
        }

        float lowest = places.Skip(200).Min(place => place.Y);
        int standing = 0;
        for (int i = 201; i < places.Count; i++)
        {
            if (places[i].Y < lowest + 1e-3f && places[i - 1].Y < lowest + 1e-3f)
            {
                standing++;
                Assert.InRange(Vector3.Distance(places[i], places[i - 1]), 0f, 2e-3f);
            }
        }

        Assert.InRange(standing, 60, 160);
    }

    [Fact]
    public void Arms_that_are_held_out_for_binding_hang()
    {
        var walk = new Walk(new RiggedBody(Person(0f)));
        walk.Step(0f);
        foreach (string side in new[] { "Left", "Right" })
        {
            Vector3 shoulder = walk.At($"mixamorig:{side}Arm");
            Vector3 elbow = walk.At($"mixamorig:{side}ForeArm");
            Vector3 hand = walk.At($"mixamorig:{side}Hand");
            Assert.InRange(elbow.Y, shoulder.Y - 0.29f, shoulder.Y - 0.25f);
            Assert.InRange(hand.Y, shoulder.Y - 0.54f, shoulder.Y - 0.48f);
            Assert.Equal(side == "Left", hand.X > 0f);
        }
    }

    [Fact]
    public void Where_the_model_has_its_ground_makes_no_difference()
    {
        var low = new Walk(new RiggedBody(Person(0f), 0f));
        var high = new Walk(new RiggedBody(Person(5f), 5f));
        for (int i = 0; i < 120; i++)
        {
            low.Step(2f);
            high.Step(2f);
        }

        for (int joint = 0; joint < low.Body.Skeleton.Count; joint++)
        {
            Assert.InRange(Vector3.Distance(low.Model.Positions[joint] + new Vector3(0f, 5f, 0f), high.Model.Positions[joint]), 0f, 1e-3f);
        }
    }

    [Fact]
    public void A_skeleton_in_centimetres_moves_as_the_same_one_in_metres()
    {
        var metres = new Walk(new RiggedBody(Person(0f)));
        var centimetres = new Walk(new RiggedBody(Skeleton.Build(Placements(0f).ConvertAll(joint => joint with { Position = joint.Position * 100f })), unit: 0.01f));
        for (int i = 0; i < 120; i++)
        {
            metres.Step(2f);
            centimetres.Step(2f);
        }

        for (int joint = 0; joint < metres.Body.Skeleton.Count; joint++)
        {
            Assert.InRange(Vector3.Distance(metres.Model.Positions[joint] * 100f, centimetres.Model.Positions[joint]), 0f, 0.1f);
        }

        Clip walk = ClipBaker.RecipesOf(new MotionProfile(centimetres.Body.Subject)).Single(recipe => recipe.Name == "Walk").Bake();
        Assert.Equal(100f * walk.Speed, centimetres.Body.Bring(walk).Speed, 0.01f);
    }

    /// <summary>Skeletons that grew, of which only the names of joints and their places are kept; those of walkers on two to sixteen legs.</summary>
    [Theory]
    [MemberData(nameof(Seeds))]
    public void A_grown_skeleton_that_comes_from_elsewhere_goes_on_all_its_legs(ulong seed)
    {
        Creature creature = Walkers.Any(seed);
        int legs = creature.Limbs.Count(limb => limb.Kind == LimbKind.Leg && limb.Stands);
        Skeleton stranger = Skeleton.Build(creature.Skeleton.Joints.Select(joint => new JointPlacement(joint.Name, joint.Parent, joint.LocalRotation, joint.LocalPosition)).ToArray());
        var walk = new Walk(new RiggedBody(stranger, 0f));
        Assert.Equal(legs, walk.Body.Subject.Limbs.Count(limb => limb.Kind == LimbKind.Leg && limb.Stands));
        float length = walk.Animator.Profile.LegLength;
        for (int i = 0; i < 240; i++)
        {
            walk.Step(walk.Body.Subject.DefaultSpeed);
            walk.AssertFeetFollow(1e-3f * length);
            walk.AssertNoBallSinks(0.01f * length);
            Assert.All(walk.Model.Positions.ToArray(), place => Assert.True(float.IsFinite(place.X + place.Y + place.Z)));
        }

        Assert.True(walk.Animator.Root.Position.Z > 2f * walk.Body.Subject.DefaultSpeed);
    }

    public static TheoryData<ulong> Seeds() => new(Enumerable.Range(1, 16).Select(seed => (ulong)seed).Where(seed => Walkers.Any(seed).Limbs.Any(limb => limb.Kind == LimbKind.Leg && limb.Stands)));

    [Fact]
    public void It_falls_and_gets_up_again()
    {
        var walk = new Walk(new RiggedBody(Person(0f)));
        float standing = Height(walk);
        walk.Animator.GoLimp();
        for (int i = 0; i < 120; i++)
        {
            walk.Step(0f);
        }

        Assert.InRange(Height(walk), 0f, 0.5f * standing);
        walk.Animator.GetUp();
        for (int i = 0; i < 240; i++)
        {
            walk.Step(0f);
        }

        Assert.InRange(Height(walk), 0.95f * standing, 1.02f * standing);

        static float Height(Walk walk)
        {
            walk.Step(0f);
            return walk.Animator.Root.ToWorld(walk.At("mixamorig:Head")).Y;
        }
    }

    [Fact]
    public void Bringing_a_pose_over_allocates_nothing()
    {
        var walk = new Walk(new RiggedBody(Person(0f)));
        walk.Step(1f);
        Assert.Equal(0, MovingPose.Allocated(() => walk.Step(1f), 1));
    }

    [Fact]
    public void What_cannot_stand_is_refused_with_what_it_lacks()
    {
        Assert.Throws<ArgumentNullException>(() => new RiggedBody(null!));
        Assert.Contains("no pair of legs that stands", Refusal(() => new RiggedBody(Skeleton.Build(Placements(0f).Take(6).ToArray()))), StringComparison.Ordinal);
        Assert.Contains("no pelvis, spine or chest", Refusal(() => new RiggedBody(Skeleton.Build([new JointPlacement("thing", -1, Quaternion.Identity, Vector3.Zero)]))), StringComparison.Ordinal);
        foreach (float height in new[] { 1f, float.NaN, float.NegativeInfinity, float.PositiveInfinity })
        {
            Assert.Contains("expected ground below all hips", Refusal(() => new RiggedBody(Person(0f), height)), StringComparison.Ordinal);
        }

        foreach (float unit in new[] { 0f, -1f, float.NaN, float.PositiveInfinity })
        {
            Assert.Contains("expected a positive number of metres", Refusal(() => new RiggedBody(Person(0f), unit: unit)), StringComparison.Ordinal);
        }

        foreach (float mass in new[] { 0f, -1f, float.NaN, float.PositiveInfinity })
        {
            Assert.Contains("expected a positive number of kilograms", Refusal(() => new RiggedBody(Person(0f), mass: mass)), StringComparison.Ordinal);
        }

        var walk = new Walk(new RiggedBody(Person(0f)));
        Assert.Contains("expected", Refusal(() => walk.Body.FillPose(walk.Model, walk.Local, walk.Model)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_clip_of_the_stand_in_becomes_one_of_the_skeleton_frame_by_frame()
    {
        var body = new RiggedBody(Person(0f));
        var profile = new MotionProfile(body.Subject);
        Clip walk = ClipBaker.RecipesOf(profile).Single(recipe => recipe.Name == "Walk").Bake();
        Clip brought = body.Bring(walk);
        Assert.Equal((walk.Frames, walk.Rate, walk.Speed, walk.End), (brought.Frames, brought.Rate, brought.Speed, brought.End));
        Assert.Equal(body.Skeleton.Count, brought.Joints);
        Assert.Equal(["mixamorig:LeftToeBase", "mixamorig:RightToeBase"], brought.Events.Select(one => one.Joint).Distinct().Order(StringComparer.Ordinal));
        Assert.Throws<ArgumentNullException>(() => body.Bring(null!));
        Assert.Contains("of the stand-in", Refusal(() => body.Bring(brought)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_mass_that_is_given_is_the_one_it_has()
    {
        Assert.Equal(70f, new RiggedBody(Person(0f), mass: 70f).Subject.Mass.Mass);
        Assert.InRange(new RiggedBody(Person(0f)).Subject.Mass.Mass, 40f, 120f);
    }

    private static string Refusal(Action action) => Assert.ThrowsAny<ArgumentException>(action).Message;

    private static Skeleton Person(float floor) => Skeleton.Build(Placements(floor));

    private static List<JointPlacement> Placements(float floor)
    {
        List<JointPlacement> joints =
        [
            Joint("Hips", -1, 0f, floor + 0.98f, 0f), Joint("Spine", 0, 0f, 0.12f, 0f), Joint("Spine1", 1, 0f, 0.2f, 0f),
            Joint("Neck", 2, 0f, 0.22f, 0f), Joint("Head", 3, 0f, 0.1f, 0.02f), Joint("HeadTop_End", 4, 0f, 0.2f, 0f),
        ];
        foreach ((string side, float x) in new[] { ("Left", 1f), ("Right", -1f) })
        {
            int first = joints.Count;
            joints.AddRange([Joint(side + "UpLeg", 0, 0.1f * x, -0.04f, 0f), Joint(side + "Leg", first, 0f, -0.45f, 0.01f), Joint(side + "Foot", first + 1, 0f, -0.40f, -0.02f), Joint(side + "ToeBase", first + 2, 0f, -0.05f, 0.15f)]);
            joints.AddRange([Joint(side + "Arm", 2, 0.19f * x, 0.16f, 0f), Joint(side + "ForeArm", first + 4, 0.28f * x, 0f, 0f), Joint(side + "Hand", first + 5, 0.25f * x, 0f, 0f)]);
        }

        return joints;

        static JointPlacement Joint(string name, int parent, float x, float y, float z) => new("mixamorig:" + name, parent, Quaternion.Identity, new Vector3(x, y, z));
    }

    /// <summary>A body under way.</summary>
    private sealed class Walk(RiggedBody body)
    {
        private readonly Quaternion[] localRotations = new Quaternion[body.Skeleton.Count];
        private readonly Vector3[] localPositions = new Vector3[body.Skeleton.Count];
        private readonly Quaternion[] modelRotations = new Quaternion[body.Skeleton.Count];
        private readonly Vector3[] modelPositions = new Vector3[body.Skeleton.Count];

        public RiggedBody Body => body;

        public CreatureAnimator Animator { get; } = new(new MotionProfile(body.Subject));

        public Pose Local => new(localRotations, localPositions);

        public Pose Model => new(modelRotations, modelPositions);

        public void Step(float speed)
        {
            Animator.Update(1f / 60f, new MotionInput(speed), ground);
            body.FillPose(Animator.ModelPose, Local, Model);
        }

        public Vector3 At(string joint) => modelPositions[body.Skeleton.IndexOf(joint)];

        public void AssertNoBallSinks(float most)
        {
            foreach (LimbChain limb in body.Subject.Limbs.Where(limb => limb.Stands))
            {
                float sunk = body.Subject.Skeleton.ModelPositions[limb.Joints[4]].Y - Animator.ModelPose.Positions[limb.Joints[4]].Y;
                Assert.InRange(sunk, float.MinValue, most);
            }
        }

        public void AssertFeetFollow(float within)
        {
            foreach (LimbChain limb in body.Subject.Limbs.Where(limb => limb.Stands))
            {
                Vector3 moved = Animator.ModelPose.Positions[limb.Joints[3]];
                float nearest = Enumerable.Range(0, body.Skeleton.Count).Min(joint => Vector3.Distance(modelPositions[joint] - new Vector3(0f, body.Ground, 0f), moved));
                Assert.InRange(nearest, 0f, within);
            }
        }
    }
}
