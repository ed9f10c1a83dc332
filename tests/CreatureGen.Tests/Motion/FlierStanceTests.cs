using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Fliers on their own legs: from standing into the air and back.</summary>
public sealed class FlierStanceTests
{
    [Theory]
    [InlineData(30f, 400)]
    [InlineData(60f, 500, Explicit = true)]
    [InlineData(144f, 600, Explicit = true)]
    public void Any_flier_with_legs_takes_off_flies_lands_and_stands(float rate, int firstSeed)
    {
        foreach ((MotionProfile profile, string name) in Standing(firstSeed, Thoroughness.Of(40)))
        {
            var flight = new Flight(profile, rate);
            flight.Go(1f, default);
            Assert.True(flight.Animator.StandsOnFeet, name);
            Assert.Empty(flight.Told);
            flight.TakeOff();
            Assert.False(flight.Animator.StandsOnFeet, name);
            Assert.True(flight.Height > 3f * profile.LegLength, $"{name}: {flight.Height} m up");
            Assert.Equal(profile.Legs!.Legs.Length, flight.Count(MotionEventKind.FootUp));
            Assert.Equal(0, flight.Count(MotionEventKind.FootDown));
            flight.Land();
            Assert.True(flight.Animator.StandsOnFeet, name);
            Assert.True(Math.Abs(flight.Height) < 0.02f * profile.LegLength, $"{name}: stands {flight.Height} m up");
            Assert.True(flight.Count(MotionEventKind.FootDown) >= profile.Legs.Legs.Length, name);
            int downs = flight.Count(MotionEventKind.FootDown) - flight.Count(MotionEventKind.FootUp);
            Assert.Equal(0, downs);
        }
    }

    [Theory]
    [InlineData(30f, 1400, Explicit = true)]
    [InlineData(60f, 1500, Explicit = true)]
    [InlineData(144f, 1600, Explicit = true)]
    public void Feet_of_fliers_hold_while_they_crouch_push_off_and_give_way(float rate, int firstSeed)
    {
        foreach ((MotionProfile profile, string name) in Standing(firstSeed, Thoroughness.Of(40)))
        {
            var flight = new Flight(profile, rate);
            flight.Go(1f, default);
            flight.Record();
            flight.TakeOff();
            flight.Drop();
            MotionReport report = flight.Report();
            Assert.True(report.Slip <= 0.001f, $"{name}: slip {report.Slip}");
            Assert.Equal(0f, report.SkatingFraction);
            Assert.True(report.MeanPenetration <= 0.001f, $"{name}: sunk {report.MeanPenetration}");
            Assert.True(report.Penetration <= 0.02f, $"{name}: sunk {report.Penetration}");
            Assert.True(report.LimitExcess <= 0.05f, $"{name}: {profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} {report.LimitExcess} rad beyond its limits");
        }
    }

    [Theory]
    [InlineData(60f, 2500, Explicit = true)]
    [InlineData(144f, 2600, Explicit = true)]
    public void Feet_of_fliers_neither_slide_nor_sink_where_they_walk(float rate, int firstSeed)
    {
        int walks = 0;
        foreach ((MotionProfile profile, string name) in Standing(firstSeed, Thoroughness.Of(40)))
        {
            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Hertz == rate && trial.Relief == GroundRelief.Flat && trial.Movement.Gait != null))
            {
                MotionReport report = trial.Run(profile);
                string run = $"{name} {trial.Movement.GaitName}";
                Assert.True(report.Slip <= 0.001f, $"{run}: slip {report.Slip}");
                Assert.Equal(0f, report.SkatingFraction);
                Assert.True(report.MeanPenetration <= 0.001f, $"{run}: sunk {report.MeanPenetration}");
                Assert.True(report.Penetration <= 0.02f, $"{run}: sunk {report.Penetration}");
                Assert.True(report.Clearance >= 0.02f, $"{run}: clearance {report.Clearance}");
                walks++;
            }
        }

        Assert.True(walks > Thoroughness.Of(60));
    }

    /// <summary>What jumps turns as far in a frame however short that is; what moves turns a quarter as far in a quarter of the time.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(8, Explicit = true)]
    [InlineData(25, Explicit = true)]
    public void No_joint_jumps_between_standing_and_flying(int count)
    {
        foreach ((MotionProfile profile, string name) in Standing(3500, count))
        {
            float fine = Turns(profile, 960f);
            Assert.True(fine < 0.12f, $"{name}: a joint turns by {fine} rad in a 960th of a second");
        }
    }

    [Fact]
    public void Taking_off_and_landing_allocate_nothing()
    {
        MotionProfile profile = Standing(4500, 5).First().Profile;
        var flight = new Flight(profile, 60f);
        Assert.Equal(0, MovingPose.Allocated(Round, 1));

        void Round()
        {
            flight.Rise(4f);
            flight.Sink(6f);
        }
    }

    [Fact]
    public void The_same_flight_gives_the_same_bits()
    {
        MotionProfile profile = Standing(4600, 5).First().Profile;
        Assert.Equal(Pose(), Pose());

        Quaternion[] Pose()
        {
            var flight = new Flight(profile, 60f);
            flight.Rise(2f);
            flight.Sink(1.3f);
            return flight.Animator.ModelPose.Rotations.ToArray();
        }
    }

    [Fact]
    public void A_flier_that_runs_takes_its_run_into_the_air()
    {
        foreach ((MotionProfile profile, string name) in Standing(5500, 10))
        {
            var flight = new Flight(profile, 60f);
            float speed = profile.Gaits!.Speeds[0].Comfortable;
            flight.Go(3f, new MotionInput(speed));
            float min = flight.Animator.Speed;
            for (int i = 0; i < 120; i++)
            {
                flight.Go(1f / 60f, new MotionInput(Math.Max(speed, profile.Flight!.CruiseSpeed), ClimbRate: 1f, Medium: MotionMedium.Air));
                min = Math.Min(min, flight.Animator.Speed);
            }

            Assert.True(min > 0.8f * speed, $"{name}: {min} of {speed} m/s");
        }
    }

    [Theory]
    [InlineData(60f, 7500)]
    [InlineData(144f, 7600, Explicit = true)]
    public void A_flier_that_lands_as_it_goes_ahead_runs_out(float rate, int firstSeed)
    {
        int ran = 0;
        foreach ((MotionProfile profile, string name) in Standing(firstSeed, Thoroughness.Of(30)))
        {
            var flight = new Flight(profile, rate);
            flight.TakeOff();
            float length = profile.LegLength;
            float unit = MathF.Sqrt(9.81f * length);
            float before = flight.Animator.Speed;
            float touched = float.NaN;
            flight.Told.Clear();
            flight.EachFrame = () =>
            {
                // Braking in the air takes the way down, that on the ground the usual response of 4 per second.
                float now = flight.Animator.Speed;
                float max = 1.02f * MathF.Max(4f * before, 3f * unit * unit / length) / rate;
                Assert.True(Math.Abs(now - before) <= max, $"{name}: from {before} to {now} m/s at once, {flight.Height / length} leg lengths up");
                touched = float.IsNaN(touched) && flight.Animator.StandsOnFeet ? now : touched;
                before = now;
            };
            flight.Record();
            flight.Land();
            MotionReport report = flight.Report();
            Assert.True(report.Slip <= 0.001f, $"{name}: slip {report.Slip}");
            Assert.Equal(0f, report.SkatingFraction);

            // Walkers that stop from such a run go as far beyond the limits of their feet.
            Assert.True(report.LimitExcess <= 0.13f, $"{name}: {profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} {report.LimitExcess} rad beyond its limits");
            int downs = flight.Count(MotionEventKind.FootDown);
            if (touched > 0.5f * unit)
            {
                Assert.True(downs > profile.Legs!.Legs.Length, $"{name}: {downs} steps from {touched} m/s");
                ran++;
            }

            Assert.True(Math.Abs(flight.Animator.Speed) < 0.01f * unit, $"{name}: {flight.Animator.Speed} m/s in the end");
        }

        Assert.True(ran > Thoroughness.Of(15), $"{ran} ran");
    }

    [Fact]
    public void A_flier_that_comes_straight_down_stays_where_it_lands()
    {
        foreach ((MotionProfile profile, string name) in Standing(7700, 15))
        {
            var flight = new Flight(profile, 60f);
            flight.TakeOff();
            flight.Go(1f, new MotionInput(0f, Medium: MotionMedium.Air));
            for (int i = 0; i < 4000 && !flight.Animator.StandsOnFeet; i++)
            {
                flight.Go(1f / 60f, new MotionInput(0f, ClimbRate: -0.3f * profile.Flight!.CruiseSpeed));
            }

            Vector3 place = flight.Animator.Root.Position;
            flight.Go(2f, default);
            Assert.True(Vector3.Distance(place, flight.Animator.Root.Position) < 0.03f * profile.LegLength, name);
            Assert.Equal(profile.Legs!.Legs.Length, flight.Count(MotionEventKind.FootDown));
        }
    }

    [Fact]
    public void A_flier_told_to_climb_again_before_it_is_down_flies_on()
    {
        foreach ((MotionProfile profile, string name) in Standing(6500, 10))
        {
            var flight = new Flight(profile, 60f);
            flight.TakeOff();
            while (flight.Height > 0.3f * profile.LegLength)
            {
                flight.Sink(1f / 60f);
            }

            flight.Told.Clear();
            flight.Rise(3f);
            Assert.Empty(flight.Told);
            Assert.True(flight.Height > 2f * profile.LegLength, name);
        }
    }

    [Fact]
    public void Fliers_without_legs_never_touch_the_ground()
    {
        int tried = 0;
        foreach (MotionProfile profile in Blueprints(0, 400).Where(blueprint => blueprint.Legs.Count == 0).Select(Profile))
        {
            var flight = new Flight(profile, 60f);
            flight.Rise(3f);
            flight.Sink(5f);
            Assert.Empty(flight.Told);
            Assert.False(flight.Animator.StandsOnFeet);
            tried++;
        }

        Assert.True(tried > 2);
    }

    [Theory]
    [InlineData(50, Explicit = true)]
    [InlineData(150, Explicit = true)]
    public void Nearly_all_fliers_that_have_legs_stand_on_them(int count)
    {
        int legs = 0;
        int stand = 0;
        foreach (MotionProfile profile in Fliers(8000, count))
        {
            legs += profile.Subject.Creature!.Blueprint.Legs.Count > 0 ? 1 : 0;
            stand += profile.Legs != null ? 1 : 0;
        }

        Assert.True(stand >= legs - 1, $"{stand} of {legs}");
        Assert.True(stand > 0.8 * count);
    }

    private static IEnumerable<CreatureBlueprint> Blueprints(int firstSeed, int count) => Enumerable.Range(firstSeed, count)
        .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 0 }));

    private static MotionProfile Profile(CreatureBlueprint blueprint) => new(CreatureGenerator.Build(blueprint));

    private static IEnumerable<MotionProfile> Fliers(int firstSeed, int count) => Blueprints(firstSeed, count).Select(Profile);

    private static IEnumerable<(MotionProfile Profile, string Name)> Standing(int firstSeed, int count) => Fliers(firstSeed, count)
        .Where(profile => profile.Legs != null)
        .Select(profile => (profile, $"{profile.Subject.Seed} {profile.Subject.Creature!.Blueprint.Body.Blend.First} of {profile.Legs!.Legs.Length} legs"));

    /// <summary>The farthest that a joint other than those of wings and springs turns in a frame.</summary>
    private static float Turns(MotionProfile profile, float rate)
    {
        var flight = new Flight(profile, rate);
        flight.Go(0.5f, default);
        Skeleton skeleton = profile.Subject.Skeleton;
        Quaternion[] before = flight.Animator.LocalPose.Rotations.ToArray();
        float max = 0f;
        flight.EachFrame = () =>
        {
            ReadOnlySpan<Quaternion> now = flight.Animator.LocalPose.Rotations;
            for (int j = 0; j < now.Length; j++)
            {
                if (skeleton.Joints[j].Role is not (JointRole.Wing or JointRole.Lid or JointRole.Tail or JointRole.Ear or JointRole.Antenna))
                {
                    max = Math.Max(max, (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), now[j])));
                }
            }

            now.CopyTo(before);
        };
        flight.TakeOff();
        flight.Land();
        return max;
    }

    /// <summary>An animator that is sent up and down.</summary>
    private sealed class Flight
    {
        private readonly MotionProfile profile;
        private readonly float step;
        private MotionRecorder? recorder;

        public Flight(MotionProfile profile, float rate)
        {
            this.profile = profile;
            step = 1f / rate;
            Animator = new CreatureAnimator(profile);
            Animator.Teleport(RootPlace.Identity, FlatGround.Level);
        }

        public CreatureAnimator Animator { get; }

        /// <summary>Steps of feet told so far.</summary>
        public List<MotionEventKind> Told { get; } = new(1024);

        public Action? EachFrame { get; set; }

        public float Height => Animator.Root.Position.Y;

        private float Cruise => profile.Flight!.CruiseSpeed;

        private float Length => profile.LegLength > 0f ? profile.LegLength : 0.5f;

        public int Count(MotionEventKind kind) => Told.Count(told => told == kind);

        public void Record() => recorder = new MotionRecorder(Animator);

        public MotionReport Report() => recorder!.Report();

        public void Rise(float seconds) => Go(seconds, new MotionInput(0.4f * Cruise, ClimbRate: 0.3f * Cruise, Medium: MotionMedium.Air));

        public void Sink(float seconds) => Go(seconds, new MotionInput(0.4f * Cruise, ClimbRate: -0.3f * Cruise));

        public void TakeOff()
        {
            for (int i = 0; i < 4000 && Height <= 3f * Length; i++)
            {
                Rise(step);
            }

            Rise(0.5f);
        }

        /// <summary>Comes down, runs out, and stands for a time.</summary>
        public void Land()
        {
            for (int i = 0; i < 4000 && !Animator.StandsOnFeet; i++)
            {
                Sink(step);
            }

            Go(4f, default);
        }

        /// <summary>Comes straight down, and stands for a time.</summary>
        public void Drop()
        {
            for (int i = 0; i < 4000 && !Animator.StandsOnFeet; i++)
            {
                Go(step, new MotionInput(0f, ClimbRate: -0.3f * Cruise));
            }

            Go(2f, default);
        }

        public void Go(float seconds, MotionInput input)
        {
            int frames = Math.Max(1, (int)Math.Round(seconds / step));
            for (int i = 0; i < frames; i++)
            {
                Animator.Update(step, input, FlatGround.Level);
                foreach (MotionEvent item in Animator.Events)
                {
                    if (item.Foot >= 0)
                    {
                        Told.Add(item.Kind);
                    }
                }

                recorder?.Record(step, FlatGround.Level);
                EachFrame?.Invoke();
            }
        }
    }
}
