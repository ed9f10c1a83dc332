using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Flying;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

public sealed class FlightMotionTests
{
    public static IEnumerable<TheoryDataRow<BodyPlan>> Plans => [new(BodyPlan.Flapping), new(BodyPlan.Buzzing) { Explicit = true }];

    [Theory]
    [MemberData(nameof(Plans))]
    public void Every_joint_stays_within_its_limits_whatever_is_asked(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            var body = new StrokeSubject(creature);
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var state = default(FlightState);
            for (int i = 0; i < 800; i++)
            {
                double t = i / 40.0;
                var input = new FlightInput(
                    (int)(t / 5) % 2 == 0 ? FlightIntent.Air : FlightIntent.Ground,
                    (float)(profile.CruiseSpeed * (1 + PortableMath.Sin(t))),
                    (float)(3 * PortableMath.Sin(2.1 * t)),
                    (float)(profile.CruiseSpeed * 1.5 * PortableMath.Sin(1.3 * t)),
                    (float)(profile.LegLength * (1 + PortableMath.Sin(0.4 * t)) * 2));
                FlightMotion.Update(profile, input, ref state, 1 / (12 * profile.BeatFrequency), body.Local);
                body.AssertWithinLimits(FormattableString.Invariant($"{plan} {creature.Blueprint.Seed} step {i} {state.Phase}"));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void Straight_flight_is_symmetric(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            FlightState state = FlightState.InAir(profile);
            for (int i = 0; i < 100; i++)
            {
                FlightMotion.Update(profile, Level(profile), ref state, 0.013f, body.Local);
                Assert.True(body.ApartFromMirror(body.Rotations) < 2e-3);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void A_slow_cycle_under_steady_input_closes(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            foreach (float cruises in new[] { 0f, 1f })
            {
                var body = new StrokeSubject(creature);
                FlightInput input = Level(profile) with { Speed = cruises * profile.CruiseSpeed };
                FlightState state = Steady(profile, input, body);
                Quaternion[] first = (Quaternion[])body.Rotations.Clone();
                Vector3 place = body.Positions[profile.Chain.Body];
                double period = profile.BeatsPerCycle / state.Frequency.Value;
                int steps = 20 * profile.BeatsPerCycle;
                for (int i = 0; i < steps; i++)
                {
                    FlightMotion.Update(profile, input, ref state, (float)(period / steps), body.Local);
                }

                Assert.True(body.Apart(first) < 2e-3, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: {body.Apart(first)}"));
                Assert.True(Vec.Distance(place, body.Positions[profile.Chain.Body]) < 1e-3f * profile.WingSpan);
            }
        }
    }

    [Fact]
    public void Wings_beat_as_often_as_birds_of_that_build()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Flapping, 8))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            Assert.InRange(profile.BeatFrequency, 0.8f, 9f);
            Assert.InRange(profile.WingSurface / (profile.WingSpan * profile.WingSpan), 0.03f, 0.4f);
        }
    }

    [Fact]
    public void The_tip_of_a_wing_goes_high_and_low_and_draws_in_on_the_way_up()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Flapping))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            FlightInput input = Level(profile) with { ClimbRate = 0.3f * profile.CruiseSpeed };
            FlightState state = Steady(profile, input, body);
            int tip = creature.Skeleton.IndexOf("Wing_L1_End");
            double top = double.MinValue, bottom = double.MaxValue, down = 0, up = 0;
            int downs = 0, ups = 0;
            for (int i = 0; i < 100; i++)
            {
                FlightMotion.Update(profile, input, ref state, (float)(0.01 / state.Frequency.Value), body.Local);
                body.ToModel();
                Vector3 p = body.ModelPositions[tip];
                top = Math.Max(top, p.Y);
                bottom = Math.Min(bottom, p.Y);
                double phase = (state.Cycle * profile.BeatsPerCycle) % 1;
                if (phase is > 0.2 and < 0.4)
                {
                    down += p.X;
                    downs++;
                }
                else if (phase is > 0.7 and < 0.9)
                {
                    up += p.X;
                    ups++;
                }
            }

            double stroke = (top - bottom) / profile.WingSpan;
            Assert.True(stroke is > 0.25 and < 0.75, FormattableString.Invariant($"{creature.Blueprint.Seed}: stroke {stroke} spans"));
            Assert.True(up / ups < 0.93 * (down / downs), FormattableString.Invariant($"{creature.Blueprint.Seed}: half span {down / downs} down, {up / ups} up"));
        }
    }

    [Fact]
    public void The_tip_of_an_insects_wing_draws_a_figure_of_eight()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Buzzing))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            FlightInput input = Level(profile) with { Speed = 0 };
            FlightState state = Steady(profile, input, body);
            int tip = creature.Skeleton.IndexOf("InsectWing_L1_End");
            const int Count = 120;
            var path = new Vector2[Count];
            for (int i = 0; i < Count; i++)
            {
                FlightMotion.Update(profile, input, ref state, (float)(1.0 / Count / state.Frequency.Value), body.Local);
                body.ToModel();
                int chest = creature.Skeleton.Parents[creature.Skeleton.IndexOf("InsectWing_L1_1")];
                Vector3 p = Rotation.Rotate(Rotation.Inverse(body.ModelRotations[chest]), body.ModelPositions[tip] - body.ModelPositions[chest]);
                path[i] = new Vector2(p.Y, p.Z);
            }

            int crossings = 0;
            for (int i = 0; i < Count; i++)
            {
                for (int k = i + 2; k < Count; k++)
                {
                    crossings += (k + 1) % Count != i && Cross(path[i], path[(i + 1) % Count], path[k], path[(k + 1) % Count]) ? 1 : 0;
                }
            }

            Assert.True(crossings >= 1, FormattableString.Invariant($"{creature.Blueprint.Seed}: {crossings} crossings"));
        }
    }

    [Fact]
    public void An_insect_that_hovers_beats_to_and_fro_and_one_that_flies_up_and_down()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Buzzing))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            double flying = Slant(profile.CruiseSpeed);
            double hovering = Slant(0f);
            Assert.True(flying < 0.8 && hovering > 1.3 * flying && hovering > 0.7, $"{creature.Blueprint.Seed}: {flying} flying, {hovering} hovering");

            // How far a tip goes to and fro over how far it goes up and down.
            double Slant(float speed)
            {
                var body = new StrokeSubject(creature);
                int tip = creature.Limbs.First(limb => limb.Kind == LimbKind.InsectWing && limb.Side == Side.Left).Joints[^1];
                FlightState state = Steady(profile, Level(profile) with { Speed = speed }, body);
                var box = (Low: new Vector3(float.MaxValue), High: new Vector3(float.MinValue));
                for (int i = 0; i < 60; i++)
                {
                    FlightMotion.Update(profile, Level(profile) with { Speed = speed }, ref state, (float)(1 / 60.0 / state.Frequency.Value), body.Local);
                    body.ToModel();
                    box = (Vector3.Min(box.Low, body.ModelPositions[tip]), Vector3.Max(box.High, body.ModelPositions[tip]));
                }

                return (box.High.Z - box.Low.Z) / (box.High.Y - box.Low.Y);
            }
        }
    }

    [Fact]
    public void Every_beat_is_counted_once_at_any_frame_rate()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        var counts = new List<long>();
        foreach (int rate in new[] { 5, 30, 60, 144, 1000 })
        {
            var body = new StrokeSubject(creature);
            FlightState state = FlightState.InAir(profile);
            FlightInput input = Level(profile) with { ClimbRate = 2 * profile.CruiseSpeed };
            long told = 0;
            for (int i = 0; i < 20 * rate; i++)
            {
                FlightMotion.Update(profile, input, ref state, 1f / rate, body.Local);
                told += state.BeatsBegun;
                Assert.InRange(state.SecondsSinceBeat, 0f, 1f / rate);
            }

            Assert.Equal(state.Beats, told);
            counts.Add(state.Beats);
        }

        Assert.True(counts[0] > 20);
        Assert.True(counts.Max() - counts.Min() <= 1, string.Join(" ", counts));
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void It_crouches_leaps_flies_lands_and_folds_its_wings(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var state = default(FlightState);
            var seen = new List<FlightPhase>();
            float height = 0;
            float dt = 0.01f * (float)Math.Sqrt(profile.LegLength);
            for (int i = 0; i < 3000 && seen.Count < 7; i++)
            {
                FlightIntent intent = i < 600 ? FlightIntent.Air : FlightIntent.Ground;
                float climb = state.Phase == FlightPhase.Airborne ? (intent == FlightIntent.Air ? 0.3f : -0.3f) * profile.CruiseSpeed : 0;
                RootDelta root = FlightMotion.Update(profile, new FlightInput(intent, 0.5f * profile.CruiseSpeed, 0, climb, height), ref state, dt, body.Local);
                height = Math.Max(0, height + root.Shift.Y);
                if (seen.Count == 0 || seen[^1] != state.Phase)
                {
                    seen.Add(state.Phase);
                }

                if (state.Phase is FlightPhase.Crouching or FlightPhase.Settling && state.Age > 0.4)
                {
                    AssertFeetDown(body, profile, height);
                }
            }

            Assert.Equal(
                new[] { FlightPhase.Crouching, FlightPhase.Leaping, FlightPhase.Airborne, FlightPhase.Landing, FlightPhase.Settling, FlightPhase.Grounded },
                seen.Take(6));
            for (int i = 0; i < 300; i++)
            {
                FlightMotion.Update(profile, new FlightInput(FlightIntent.Ground, 0, 0, 0, height), ref state, dt, body.Local);
            }

            Assert.True(state.WingSpread < 0.01f);
            Assert.Equal(0f, state.Airborne);
            AssertFeetDown(body, profile, height);
        }
    }

    [Fact]
    public void Folded_wings_lie_along_the_body()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Flapping))
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var state = default(FlightState);
            FlightMotion.Update(profile, new FlightInput(FlightIntent.Ground, 0, 0, 0, 0), ref state, 0.01f, body.Local);
            body.ToModel();
            float widest = 0;
            for (int k = 1; k <= 4; k++)
            {
                int joint = creature.Skeleton.IndexOf(k == 4 ? "Wing_L1_End" : FormattableString.Invariant($"Wing_L1_{k + 1}"));
                widest = Math.Max(widest, body.ModelPositions[joint].X);
            }

            Assert.True(widest < 0.15f * profile.WingSpan, FormattableString.Invariant($"{creature.Blueprint.Seed}: {widest / profile.WingSpan} spans out"));
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void Frame_rates_agree(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        Quaternion[]? reference = null;
        foreach (int rate in new[] { 30, 60, 144 })
        {
            var body = new StrokeSubject(creature);
            FlightState state = FlightState.InAir(profile);
            for (int i = 0; i < 6 * rate; i++)
            {
                int second = i / rate;
                FlightInput input = Level(profile) with { Speed = (second % 3) * 0.6f * profile.CruiseSpeed, YawRate = second % 2 == 0 ? 0.5f : -0.4f, ClimbRate = second > 3 ? -0.3f * profile.CruiseSpeed : 0.2f * profile.CruiseSpeed };
                FlightMotion.Update(profile, input, ref state, 1f / rate, body.Local);
            }

            reference ??= (Quaternion[])body.Rotations.Clone();
            Assert.True(body.Apart(reference) < 0.01, FormattableString.Invariant($"{plan} at {rate} Hz: {body.Apart(reference)}"));
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void Changes_have_no_jump_of_angular_velocity(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        float coarse = Jerk(profile, creature, 240);
        float fine = Jerk(profile, creature, 960);
        Assert.True(fine < 0.5f * coarse, FormattableString.Invariant($"{plan}: {coarse} coarse, {fine} fine"));
    }

    [Fact]
    public void The_body_heaves_against_the_wings_and_more_slowly_beating_wings_heave_it_more()
    {
        var force = new WingForce();
        double mean = 0;
        for (int i = 0; i < 100; i++)
        {
            mean += force.At(i / 100.0) / 100;
        }

        Assert.True(Math.Abs(mean) < 1e-9);

        // Twice the derivative is the force: at the height of the downstroke it pushes up, in the upstroke weight pulls down.
        double Second(double p) => (force.At(p + 1e-3) - (2 * force.At(p)) + force.At(p - 1e-3)) / 1e-6;
        Assert.True(Second(0.28) > 0);
        Assert.True(Second(0.8) < 0);
    }

    [Fact]
    public void Banking_goes_into_the_turn_by_the_angle_of_a_coordinated_one()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        FlightInput input = Level(profile) with { YawRate = 0.4f };
        Steady(profile, input, body);
        body.ToModel();
        Vector3 left = Rotation.Rotate(body.ModelRotations[profile.Chain.Body], Vector3.UnitX);
        double bank = PortableMath.Asin(-left.Y);
        double coordinated = PortableMath.Atan2(profile.CruiseSpeed * 0.4, 9.81);
        Assert.InRange(bank, 0.85 * coordinated, coordinated + 0.02);
    }

    [Fact]
    public void Updates_allocate_nothing()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        FlightState state = FlightState.InAir(profile);
        Assert.Equal(0, MovingPose.Allocated(() => FlightMotion.Update(profile, Level(profile), ref state, 0.01f, body.Local), 200));
    }

    [Fact]
    public void The_same_inputs_give_the_same_bits_and_no_time_changes_nothing()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[1];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        var a = new StrokeSubject(creature);
        var b = new StrokeSubject(creature);
        var sa = default(FlightState);
        var sb = default(FlightState);
        for (int i = 0; i < 200; i++)
        {
            var input = new FlightInput(FlightIntent.Air, i * 0.1f, 0.1f, 0.2f, i * 0.05f);
            FlightMotion.Update(profile, input, ref sa, 0.016f, a.Local);
            FlightMotion.Update(profile, input, ref sb, 0.016f, b.Local);
        }

        Assert.Equal(a.Rotations, b.Rotations);
        FlightMotion.Update(profile, Level(profile), ref sb, 0f, b.Local);
        Assert.True(b.Apart(a.Rotations) < 1e-6);
    }

    [Theory]
    [InlineData(float.NaN, 0f, 1f, 0.1f)]
    [InlineData(1f, 0f, float.NaN, 0.1f)]
    [InlineData(1f, 0f, 1f, -1f)]
    public void Numbers_that_are_none_are_refused(float speed, float yaw, float height, float dt)
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Flapping)[0];
        FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        Assert.ThrowsAny<ArgumentException>(() =>
        {
            var state = default(FlightState);
            FlightMotion.Update(profile, new FlightInput(FlightIntent.Air, speed, yaw, 0, height), ref state, dt, body.Local);
        });
    }

    [Fact]
    public void A_creature_without_wings_is_refused() =>
        Assert.Throws<ArgumentException>(() => FlightProfile.Of(new MotionSubject(StrokeSubject.Of(BodyPlan.Fish)[0])));

    [Theory]
    [InlineData(0.05)]
    [InlineData(20)]
    public void Any_size_flies(double scale)
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Flapping, BodyPlan.Buzzing })
        {
            Creature creature = StrokeSubject.Find(plan, 1, scale, scale)[0];
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var state = default(FlightState);
            for (int i = 0; i < 200; i++)
            {
                FlightMotion.Update(profile, Level(profile), ref state, 0.05f / profile.BeatFrequency, body.Local);
                body.AssertWithinLimits(FormattableString.Invariant($"{plan} at {scale}"));
            }
        }
    }

    private static FlightInput Level(FlightProfile profile) => new(FlightIntent.Air, profile.CruiseSpeed);

    private static FlightState Steady(FlightProfile profile, FlightInput input, StrokeSubject body)
    {
        FlightState state = FlightState.InAir(profile);
        for (int i = 0; i < 1200; i++)
        {
            FlightMotion.Update(profile, input, ref state, 0.02f, body.Local);
        }

        return state;
    }

    private static float Jerk(FlightProfile profile, Creature creature, int rate)
    {
        var body = new StrokeSubject(creature);
        FlightState state = FlightState.InAir(profile);
        float dt = 1f / rate / profile.BeatFrequency * 2;
        for (int i = 0; i < 6 * rate; i++)
        {
            int part = i / rate;
            FlightInput input = Level(profile) with { Speed = (part % 3) * 0.6f * profile.CruiseSpeed, YawRate = part % 2 == 0 ? 0.5f : -0.5f, ClimbRate = (part - 3) * 0.2f * profile.CruiseSpeed };
            FlightMotion.Update(profile, input, ref state, dt, body.Local);
            body.Track(dt);
        }

        return body.Jerk;
    }

    private static void AssertFeetDown(StrokeSubject body, FlightProfile profile, float height)
    {
        body.ToModel();
        foreach (LimbChain leg in body.Creature.Limbs.Where(l => l.Kind == LimbKind.Leg))
        {
            int ball = leg.Joints[4];
            Quaternion turn = Rotation.Multiply(body.ModelRotations[ball], Rotation.Inverse(body.Skeleton.ModelRotations[ball]));
            Vector3 sole = body.ModelPositions[ball] + Rotation.Rotate(turn, leg.Contact - body.Skeleton.ModelPositions[ball]);
            Assert.True(Math.Abs(sole.Y + height) < 0.06f * profile.LegLength, FormattableString.Invariant($"{body.Creature.Blueprint.Seed}: sole at {sole.Y + height} of a leg of {profile.LegLength}"));
        }
    }

    private static bool Cross(Vector2 a, Vector2 b, Vector2 c, Vector2 d)
    {
        static float Side(Vector2 p, Vector2 q, Vector2 r) => ((q.X - p.X) * (r.Y - p.Y)) - ((q.Y - p.Y) * (r.X - p.X));
        return Side(a, b, c) * Side(a, b, d) < 0 && Side(c, d, a) * Side(c, d, b) < 0;
    }
}
