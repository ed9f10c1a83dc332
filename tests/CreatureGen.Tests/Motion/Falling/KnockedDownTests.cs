using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Walkers that are knocked down as they run, and asked to go on.</summary>
public sealed class KnockedDownTests
{
    private const float Frame = 1f / 60f;

    /// <summary>They came down on their chests, or sat on their folded legs, with their rumps up and their backs at 5 to 57° from up.</summary>
    [Theory]
    [InlineData(24730018UL)]
    [InlineData(24730019UL)]
    [InlineData(24730021UL, Explicit = true)]
    public void On_two_legs_they_lie_on_a_flank_with_their_rumps_down(ulong seed)
    {
        const float MaxUp = 0.5f;
        const float MaxRump = 0.2f;
        Fallen fallen = Of(seed);
        Assert.InRange(fallen.BackUp, -MaxUp, MaxUp);
        Assert.True(fallen.Rump < MaxRump, $"its rump is {fallen.Rump} leg lengths above its chest");
    }

    /// <summary>Its feet stretched after the ground from which its body heaved itself up, and lifted that to 1.24 of its standing height.</summary>
    [Theory]
    [InlineData(24730013UL)]
    public void Nobody_stands_on_legs_that_it_draws_in(ulong seed) => Assert.InRange(Of(seed).Gathered, 0.3f, 0.9f);

    /// <summary>Fore legs that swing ahead below the chest lift that alone, and the rump stays on the ground: the whole body rose, and hung in the air by .08 to .2 of its extent as the hooves went through below it.</summary>
    [Theory]
    [InlineData(24730005UL)]
    public void Nobody_hangs_in_the_air_over_legs_that_it_draws_in(ulong seed) => Assert.InRange(Of(seed).Hangs, 0f, 0.025f);

    /// <summary>The ground by which these rose was level at the mean height of their feet, be they on one tread or on several: all of them hung above the stairs by .33, .30, .37 and .31 of a leg.</summary>
    [Theory]
    [InlineData(24860114UL)]
    [InlineData(24870005UL)]
    [InlineData(24870004UL, Explicit = true)]
    [InlineData(24870002UL, Explicit = true)]
    public void Nobody_hangs_in_the_air_over_stairs_as_it_gets_up(ulong seed)
    {
        const float MaxHangs = 0.09f;
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var runs = new MotionInput(profile.Gaits!.Speeds[^1].Comfortable);
        var script = new CourseScript("down on stairs", [new(2f, runs), new(1f, runs with { YawRate = 2.5f }), new(2f, default), new(3f, default) { Body = BodyCommand.KnockDown }, new(9f, default) { Body = BodyCommand.GetUp }]);
        var course = new CourseSimulation(profile, script, CourseGround.Stairs, CourseRate.Of(60f));
        float hangs = 0f;
        foreach (float _ in course.Updates())
        {
            CreatureAnimator animator = course.Animator;
            hangs = animator.State == BodyState.Rising ? MathF.Max(hangs, profile.Fall.Value.Support.Lowest(animator.Root, animator.ModelPose, Vector3.UnitY, course.Surface.Ground)) : hangs;
        }

        Assert.Equal(BodyState.Supported, course.Animator.State);
        Assert.InRange(hangs / profile.LegLength, 0f, MaxHangs);
    }

    /// <summary>Long toes that pointed down held these up: at 1.08 and .95 of a leg.</summary>
    [Theory]
    [InlineData(24730004UL)]
    [InlineData(24730002UL)]
    public void Nobody_lies_on_its_toes(ulong seed) => Assert.InRange(Of(seed).Lies, 0.1f, 0.9f);

    /// <summary>These fell to the side of their seed, against one of the two blows.</summary>
    [Theory]
    [InlineData(24730005UL)]
    [InlineData(24730013UL)]
    [InlineData(24781017UL)]
    [InlineData(24781000UL, Explicit = true)]
    public void Who_is_struck_on_four_legs_as_it_stands_falls_away_from_the_blow(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.True(LeftAfter(profile, Vector3.UnitX).Y < -0.3f, "struck from its right it does not lie on its left");
        Assert.True(LeftAfter(profile, -Vector3.UnitX).Y > 0.3f, "struck from its left it does not lie on its right");
    }

    /// <summary>Where the left of a creature points once it has been knocked down from standing: up if it lies on its right, wherever it has spun to.</summary>
    private static Vector3 LeftAfter(MotionProfile profile, Vector3 direction)
    {
        Skeleton skeleton = profile.Subject.Skeleton;
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(animator, 0.5f, 60f, default, FlatGround.Level);
        animator.Hit(skeleton.FirstOf(JointRole.Head), direction * (0.8f * MathF.Sqrt(9.81f * profile.LegLength) * profile.Subject.Mass.Mass));
        float lying = 6f * MathF.Sqrt(profile.LegLength / 9.81f);
        for (float time = 0f; time < lying; time += Frame)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        int pelvis = skeleton.FirstOf(JointRole.Pelvis);
        return Rotation.Rotate(Rotation.Multiply(animator.ModelPose.Rotations[pelvis], Rotation.Inverse(skeleton.ModelRotations[pelvis])), Vector3.UnitX);
    }

    /// <summary>Runs, is knocked down, and goes on as soon as it can.</summary>
    private static Fallen Of(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var profile = new MotionProfile(creature);
        var animator = new CreatureAnimator(profile);
        var input = new MotionInput(profile.Gaits!.Speeds[^1].Comfortable);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(animator, 2f, 60f, input, FlatGround.Level);
        float stands = Trunk(animator);
        float unit = MathF.Sqrt(9.81f * profile.LegLength);
        animator.Hit(creature.Skeleton.FirstOf(JointRole.Head), Rotation.Rotate(animator.Root.Rotation, -Vector3.UnitX) * (0.8f * unit * creature.Mass.Mass));
        var fallen = new Fallen(0f, 0f, 0f, 0f, 0f);
        float hangs = 0f;
        var heights = new List<float>();
        for (int i = 0; i < 3000 && (i < 3 || animator.State != BodyState.Supported); i++)
        {
            animator.Update(Frame, input, FlatGround.Level);
            if (animator.State == BodyState.Limp)
            {
                int pelvis = creature.Skeleton.FirstOf(JointRole.Pelvis);
                int chest = creature.Skeleton.FirstOf(JointRole.Chest);
                ReadOnlySpan<Vector3> places = animator.ModelPose.Positions;
                Quaternion turn = Rotation.Multiply(animator.ModelPose.Rotations[pelvis], Rotation.Inverse(creature.Skeleton.ModelRotations[pelvis]));
                fallen = new Fallen(Rotation.Rotate(turn, Vector3.UnitY).Y, (places[pelvis].Y - places[chest].Y) / profile.LegLength, Trunk(animator) / profile.LegLength, 0f, 0f);
            }
            else
            {
                heights.Add(Trunk(animator));
                hangs = MathF.Max(hangs, animator.State == BodyState.Rising ? GettingUpTests.Lowest(animator) : 0f);
            }
        }

        Assert.Equal(BodyState.Supported, animator.State);
        return fallen with { Gathered = heights.Take(heights.Count / 2).Max() / stands, Hangs = hangs / GettingUpTests.Extent(creature) };
    }

    /// <summary>How high the middle of the trunk is above the ground, metres.</summary>
    private static float Trunk(CreatureAnimator animator) => animator.Root.Position.Y + animator.Profile.Fall.Value.TrunkHeight(animator.ModelPose);

    /// <summary>How it lay at last.</summary>
    /// <param name="BackUp">Cosine of its back from up.</param>
    /// <param name="Rump">How high its pelvis was above its chest, leg lengths.</param>
    /// <param name="Lies">How high the middle of its trunk was, leg lengths.</param>
    /// <param name="Gathered">How high that was at most in the first half of getting up, parts of how high it stands.</param>
    /// <param name="Hangs">How high all of its skin was above the ground at most in getting up, parts of its extent.</param>
    private readonly record struct Fallen(float BackUp, float Rump, float Lies, float Gathered, float Hangs);
}
