using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Retargeting;

public sealed class RetargetingTests
{
    private static readonly Creature biped = Walkers.Of(Anatomy.BodyPlan.Theropod, 3);
    private static readonly Creature cat = SpeciesSubject.Of("feline", RequestedKind.Walking);

    /// <summary>A dog of boxes as other programs name the joints, with bones along −Y and its hips turned.</summary>
    private static readonly Skeleton dog = Skeleton.Build([
        Joint("Bip01 Pelvis", -1, 0f, 0.6f, -0.3f), Joint("Bip01 Spine", 0, 0f, 0f, 0.3f), Joint("Bip01 Spine1", 1, 0f, 0f, 0.3f), Joint("Bip01 Neck", 2, 0f, 0.15f, 0.15f), Joint("Bip01 Head", 3, 0f, 0.1f, 0.1f), Joint("Bip01 Tail", 0, 0f, 0f, -0.2f),
        Joint("Bip01 L Thigh", 0, 0.1f, -0.05f, 0f), Joint("Bip01 L Calf", 6, 0f, -0.25f, 0.05f), Joint("Bip01 L Foot", 7, 0f, -0.2f, -0.08f), Joint("Bip01 L Toe0", 8, 0f, -0.08f, 0.05f),
        Joint("Bip01 R Thigh", 0, -0.1f, -0.05f, 0f), Joint("Bip01 R Calf", 10, 0f, -0.25f, 0.05f), Joint("Bip01 R Foot", 11, 0f, -0.2f, -0.08f), Joint("Bip01 R Toe0", 12, 0f, -0.08f, 0.05f),
        Joint("Bip01 L UpperArm", 2, 0.1f, -0.05f, 0f), Joint("Bip01 L Forearm", 14, 0f, -0.22f, -0.05f), Joint("Bip01 L Hand", 15, 0f, -0.28f, 0.04f),
        Joint("Bip01 R UpperArm", 2, -0.1f, -0.05f, 0f), Joint("Bip01 R Forearm", 17, 0f, -0.22f, -0.05f), Joint("Bip01 R Hand", 18, 0f, -0.28f, 0.04f),
    ]);

    [Fact]
    public void A_person_s_walk_moves_a_grown_biped_s_legs_against_each_other_at_its_own_scale()
    {
        var map = new RetargetMap(Person.Skeleton, biped.Skeleton);
        Clip walk = ClipRetargeting.Apply(Person.Walk(), map, "HumanWalk");
        Assert.Equal((ClipEnd.Loops, 31), (walk.End, walk.Frames));
        Assert.Equal(Person.Stride * map.Scale, walk.Speed, 1e-4f);
        int left = Find(biped.Skeleton, JointRole.Ankle, Anatomy.Side.Left);
        int right = Find(biped.Skeleton, JointRole.Ankle, Anatomy.Side.Right);
        float[] ahead = [.. Enumerable.Range(0, walk.Frames).Select(frame => Place(biped.Skeleton, walk, frame)[left].Z - Place(biped.Skeleton, walk, frame)[right].Z)];
        float leg = new MotionProfile(biped).LegLength;
        Assert.True(ahead.Max() > 0.35f * leg, $"{ahead.Max() / leg}");
        Assert.True(ahead.Min() < -0.35f * leg, $"{ahead.Min() / leg}");
    }

    [Fact]
    public void Feet_go_where_those_of_the_other_go_and_joints_keep_to_their_limits()
    {
        var map = new RetargetMap(Person.Skeleton, biped.Skeleton);
        KeyedClip original = Person.Walk();
        Clip walk = ClipRetargeting.Apply(original, map, "HumanWalk");
        int foot = Find(biped.Skeleton, JointRole.Ball, Anatomy.Side.Left);
        int other = Person.Skeleton.IndexOf("mixamorig:LeftToeBase");
        for (int frame = 0; frame < walk.Frames; frame++)
        {
            Vector3 moved = Place(Person.Skeleton, original, frame / 30f)[other] - Person.Skeleton.ModelPositions[other];
            Vector3 wanted = biped.Skeleton.ModelPositions[foot] + (map.Scale * moved);
            Assert.True(Vector3.Distance(wanted, Place(biped.Skeleton, walk, frame)[foot]) < 0.06f * new MotionProfile(biped).LegLength, $"frame {frame}: {Vector3.Distance(wanted, Place(biped.Skeleton, walk, frame)[foot])}");
            for (int joint = 0; joint < biped.Skeleton.Count; joint++)
            {
                Quaternion local = walk.RotationsAt(frame)[joint];
                Quaternion clamped = SwingTwistLimit.ClampLocal(local, biped.Skeleton.Joints[joint]);
                Assert.True(Math.Abs(Quaternion.Dot(local, clamped)) > 0.9999f, biped.Skeleton.Joints[joint].Name);
            }
        }
    }

    [Fact]
    public void A_grown_walk_moves_a_foreign_quadruped_and_its_feet_stay_on_the_ground()
    {
        Clip walk = ClipBaker.Bake(cat).First(clip => clip.Name == "Walk");
        var map = new RetargetMap(cat.Skeleton, dog);
        Clip retargeted = ClipRetargeting.Apply(walk, map, "DogWalk");
        Assert.Equal(dog.Count, map.Count);
        foreach (string name in new[] { "Bip01 L Toe0", "Bip01 R Toe0", "Bip01 L Hand", "Bip01 R Hand" })
        {
            int foot = dog.IndexOf(name);
            float[] heights = [.. Enumerable.Range(0, retargeted.Frames).Select(frame => Place(dog, retargeted, frame)[foot].Y - dog.ModelPositions[foot].Y)];
            float[] places = [.. Enumerable.Range(0, retargeted.Frames).Select(frame => Place(dog, retargeted, frame)[foot].Z)];
            Assert.True(heights.Min() > -0.02f && heights.Max() is > 0.01f and < 0.2f, $"{name}: {heights.Min()} to {heights.Max()}");
            Assert.True(places.Max() - places.Min() > 0.1f, name);
        }
    }

    /// <summary>The dog's fore paws hang on its wrists, those of the cat on balls below them.</summary>
    [Theory]
    [InlineData("Bip01 L Toe0", "Leg_L2_Ball")]
    [InlineData("Bip01 R Hand", "Leg_R1_Ball")]
    public void Paws_of_a_foreign_quadruped_go_where_those_of_the_cat_go_whatever_the_joint_is_that_carries_them(string paw, string ball)
    {
        Clip walk = ClipBaker.Bake(cat).First(clip => clip.Name == "Walk");
        var map = new RetargetMap(cat.Skeleton, dog);
        Clip retargeted = ClipRetargeting.Apply(walk, map, "DogWalk");
        (int foot, int other) = (dog.IndexOf(paw), cat.Skeleton.IndexOf(ball));
        for (int frame = 0; frame < retargeted.Frames; frame++)
        {
            Vector3 moved = Place(cat.Skeleton, walk, retargeted.TimeOf(frame) * walk.Duration / retargeted.Duration)[other] - cat.Skeleton.ModelPositions[other];
            float off = Vector3.Distance(dog.ModelPositions[foot] + (map.Scale * moved), Place(dog, retargeted, frame)[foot]);
            Assert.True(off < 0.04f * 0.55f, $"frame {frame}: {off}");
        }
    }

    /// <summary>A sprawler's hips are low for how far its feet go: four times its steps are more than an upright leg reaches.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    public void A_sprawler_s_walk_on_an_upright_dog_takes_steps_that_its_legs_reach(ulong seed)
    {
        Creature sprawler = Walkers.Of(Anatomy.BodyPlan.Sprawling, seed);
        Clip walk = ClipBaker.Bake(sprawler).First(clip => clip.Name is "Walk" or "Crawl");
        var map = new RetargetMap(sprawler.Skeleton, dog);
        Clip made = ClipRetargeting.Apply(walk, map, "DogWalk");
        float scale = made.Speed * made.Duration / (walk.Speed * walk.Duration);
        Assert.InRange(scale, 0.3f * map.Scale * 0.89f, map.Scale);
        foreach ((string paw, string ball) in new[] { ("Bip01 L Toe0", "Leg_L2_Ball"), ("Bip01 R Toe0", "Leg_R2_Ball") })
        {
            (int foot, int other) = (dog.IndexOf(paw), sprawler.Skeleton.IndexOf(ball));
            for (int frame = 0; frame < made.Frames; frame++)
            {
                Vector3 moved = Place(sprawler.Skeleton, walk, made.TimeOf(frame) * walk.Duration / made.Duration)[other] - sprawler.Skeleton.ModelPositions[other];
                float off = Vector3.Distance(dog.ModelPositions[foot] + (scale * moved), Place(dog, made, frame)[foot]);
                Assert.True(off < 0.06f * 0.55f, $"{paw} frame {frame}: {off}");
            }
        }
    }

    [Fact]
    public void Events_come_along_at_the_joints_that_do_the_same()
    {
        ClipEvent step = Assert.Single(ClipRetargeting.Apply(Person.Walk(), new RetargetMap(Person.Skeleton, biped.Skeleton), "HumanWalk").Events);
        Assert.Equal(("footstep", 0.25f), (step.Name, step.Time));
        Joint joint = biped.Skeleton.Joints[biped.Skeleton.IndexOf(step.Joint)];
        Assert.Equal((JointRole.Ankle, Anatomy.Side.Left), (joint.Role, joint.Side));
    }

    [Fact]
    public void Skeletons_that_have_nothing_in_common_are_refused_with_one_message()
    {
        Skeleton pole = Skeleton.Build([Joint("Pole", -1, 0f, 1f, 0f)]);
        Assert.Contains("Pole", Assert.Throws<ArgumentException>(() => new RetargetMap(pole, biped.Skeleton)).Message, StringComparison.Ordinal);
        var map = new RetargetMap(Person.Skeleton, biped.Skeleton);
        Assert.Throws<ArgumentException>(() => ClipRetargeting.Apply(Person.Walk(), new RetargetMap(biped.Skeleton, Person.Skeleton), "Walk"));
        Assert.Throws<ArgumentException>(() => ClipRetargeting.Apply(Person.Walk(), map, "two words"));
        Assert.Throws<ArgumentNullException>(() => ClipRetargeting.Apply(null!, map, "Walk"));
    }

    private static int Find(Skeleton skeleton, JointRole role, Anatomy.Side side) => Enumerable.Range(0, skeleton.Count).First(joint => skeleton.Joints[joint].Role == role && skeleton.Joints[joint].Side == side);

    private static Vector3[] Place(Skeleton skeleton, Clip clip, int frame) => Place(skeleton, clip, clip.TimeOf(frame));

    private static Vector3[] Place(Skeleton skeleton, IClip clip, float time)
    {
        var pose = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        clip.Sample(time, pose);
        ForwardKinematics.LocalToModel(skeleton, pose, pose);
        return pose.Positions.ToArray();
    }

    private static JointPlacement Joint(string name, int parent, float x, float y, float z) => new(name, parent, Quaternion.Identity, new Vector3(x, y, z));
}
