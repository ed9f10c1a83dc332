using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>How the roots of creatures that swim and fly get faster, slower and round.</summary>
public sealed class RootMomentumTests
{
    private const float Rate = 120f;

    [Theory]
    [InlineData(BodyPlan.Fish, 0.3f)]
    [InlineData(BodyPlan.Eel, 0.3f, Explicit = true)]
    [InlineData(BodyPlan.Whale, 0.3f, Explicit = true)]
    [InlineData(BodyPlan.Flipper, 0.3f, Explicit = true)]
    [InlineData(BodyPlan.Flapping, 1.2f)]
    [InlineData(BodyPlan.Buzzing, 1.3f, Explicit = true)]
    public void Swimmers_and_fliers_get_faster_and_slower_as_bodies_do(BodyPlan plan, float max)
    {
        foreach (Creature creature in StrokeSubject.Of(plan, 5))
        {
            var run = new Run(creature);
            float cruise = run.Cruise;
            Vector3 began = run.Place;
            run.Go(8f, run.Ahead(cruise));
            Assert.Equal(cruise, run.Animator.Speed, 0.02f * cruise);
            float length = LengthOf(creature);
            Vector3 braked = run.Place;
            run.Go(8f, run.Ahead(0f));
            Assert.Equal(0f, run.Animator.Speed, 0.02f * cruise);
            Assert.True(Vec.Distance(braked, run.Place) > 0.3f * length, $"{creature.Blueprint.Seed}: stops within {Vec.Distance(braked, run.Place)} m");
            Assert.True(Vec.Distance(began, braked) < 8f * cruise);
            Assert.True(run.Hardest < max, $"{creature.Blueprint.Seed}: {run.Hardest} g");
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Whale)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Buzzing)]
    public void The_way_is_the_same_at_any_frame_rate(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[0];
        Vector3[] ends = new[] { 30f, 60f, 144f }.Select(rate =>
        {
            var run = new Run(creature, rate);
            for (int second = 0; second < 8; second++)
            {
                run.Go(1f, run.Ahead(((second * 3) % 5) * 0.3f * run.Cruise) with { YawRate = ((second * 2) % 5 * 0.5f) - 1f, ClimbRate = 0.1f * (second % 3) * run.Cruise });
            }

            return run.Place;
        }).ToArray();
        float way = 0.6f * 8f * new Run(creature).Cruise;
        Assert.True(Vec.Distance(ends[0], ends[2]) < 0.01f * way, $"{Vec.Distance(ends[0], ends[2])} m apart on {way} m");
        Assert.True(Vec.Distance(ends[1], ends[2]) < 0.01f * way);
    }

    /// <summary>8 m/s round at 0.6 rad/s: tan⁻¹(4.8 / 9.81), of any flier of any size.</summary>
    [Theory]
    [InlineData(0.25f)]
    [InlineData(1f)]
    [InlineData(4f)]
    public void A_flier_banks_by_the_angle_that_balances_its_turn_at_any_scale(float scale)
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Flapping, BodyPlan.Buzzing })
        {
            Creature creature = StrokeSubject.Of(plan)[1];
            var run = new Run(creature, 60f, scale);
            run.Go(12f, run.Ahead(8f));
            run.Go(8f, run.Ahead(8f) with { YawRate = 0.6f });
            Assert.Equal(26.07, run.Bank, 0.5);
        }
    }

    [Fact]
    public void In_a_stronger_gravity_a_flier_banks_less_and_beats_quicker()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        double Bank(float gravity, out float beats)
        {
            var run = new Run(creature) { Gravity = gravity };
            run.Go(10f, run.Ahead(6f));
            beats = run.Animator.Frequency;
            run.Go(6f, run.Ahead(6f) with { YawRate = 0.5f });
            return run.Bank;
        }

        double earth = Bank(9.81f, out float slow);
        double giant = Bank(2 * 9.81f, out float quick);
        Assert.Equal(Math.Atan(3 / 9.81) * 180 / Math.PI, earth, 0.5);
        Assert.Equal(Math.Atan(3 / 19.62) * 180 / Math.PI, giant, 0.5);
        Assert.True(quick > 1.2f * slow, $"{slow} and {quick} beats per second");
    }

    [Fact]
    public void A_turn_that_would_bank_a_flier_too_steeply_is_wider_than_asked()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        var run = new Run(creature);
        run.Go(8f, run.Ahead(run.Cruise));
        run.Go(6f, run.Ahead(run.Cruise) with { YawRate = 4f });
        Assert.InRange(run.Bank, 55, 62);
    }

    private static float LengthOf(Creature creature)
    {
        ReadOnlySpan<Vector3> places = creature.Skeleton.ModelPositions;
        float min = float.MaxValue;
        float max = float.MinValue;
        foreach (Vector3 place in places)
        {
            min = Math.Min(min, place.Z);
            max = Math.Max(max, place.Z);
        }

        return max - min;
    }

    /// <summary>A creature under way that is watched: fliers begin high in the air.</summary>
    private sealed class Run
    {
        private readonly float step;
        private Vector3? before;

        public Run(Creature creature, float rate = Rate, float scale = 1f)
        {
            step = 1f / rate;
            var profile = new MotionProfile(creature);
            Flies = profile.Flight != null;
            Cruise = profile.Flight?.CruiseSpeed ?? profile.Swim?.CruiseSpeed ?? creature.DefaultSpeed;
            Animator = new CreatureAnimator(profile);
            Animator.Teleport(new RootPlace(new Vector3(0f, Flies ? 200f : 0f, 0f), Quaternion.Identity, scale), FlatGround.Level);
            Go(4f, Ahead(0f));
            Hardest = 0f;
        }

        public bool Flies { get; }

        public float Cruise { get; }

        public CreatureAnimator Animator { get; }

        public Vector3 Place => Animator.Root.Position;

        /// <summary>Greatest acceleration of the root so far, in parts of standard gravity.</summary>
        public float Hardest { get; set; }

        public float Gravity
        {
            init
            {
                MotionSettings settings = Animator.Settings;
                settings.Gravity = value;
                Animator.Settings = settings;
            }
        }

        /// <summary>How far the trunk is rolled to its left, degrees.</summary>
        public double Bank
        {
            get
            {
                var skeleton = Animator.Profile.Subject.Skeleton;
                int body = skeleton.IndexOf("Body");
                Quaternion rotation = Rotation.Multiply(Animator.ModelPose.Rotations[body], Rotation.Inverse(skeleton.ModelRotations[body]));
                return -PortableMath.Asin(Rotation.Rotate(rotation, Vector3.UnitX).Y) * 180 / Math.PI;
            }
        }

        public MotionInput Ahead(float speed) => new(speed, Medium: Flies ? MotionMedium.Air : MotionMedium.Ground);

        public void Go(float seconds, MotionInput input)
        {
            for (int i = 0; i < (int)Math.Round(seconds / step); i++)
            {
                Vector3 place = Place;
                Animator.Update(step, input, FlatGround.Level);
                Vector3 velocity = (Place - place) / step;
                Hardest = before is Vector3 earlier ? Math.Max(Hardest, Vec.Distance(velocity, earlier) / step / 9.81f) : 0f;
                before = velocity;
            }
        }
    }
}
