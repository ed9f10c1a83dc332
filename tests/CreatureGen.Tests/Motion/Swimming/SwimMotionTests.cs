using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;
using Xunit;
using static CreatureGen.Tests.Motion.Swimming.SwimRun;

namespace CreatureGen.Tests.Motion.Swimming;

public sealed class SwimMotionTests
{
    public static TheoryData<BodyPlan> Plans => new(BodyPlan.Fish, BodyPlan.Eel, BodyPlan.Whale, BodyPlan.Flipper);

    [Theory]
    [InlineData(BodyPlan.Fish, nameof(SwimStyle.Carangiform))]
    [InlineData(BodyPlan.Eel, nameof(SwimStyle.Anguilliform))]
    [InlineData(BodyPlan.Whale, nameof(SwimStyle.Cetacean))]
    [InlineData(BodyPlan.Flipper, nameof(SwimStyle.Flippers))]
    public void The_build_alone_tells_how_a_creature_swims(BodyPlan plan, string style) =>
        Assert.All(
            StrokeSubject.Of(plan, 16),
            creature => Assert.Equal(creature.Blueprint.Body.Blend.First == "ray" ? nameof(SwimStyle.Disc) : style, SwimProfile.Of(new MotionSubject(creature)).Style.ToString()));

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Flipper, Explicit = true)]
    [InlineData(BodyPlan.Eel, Explicit = true)]
    [InlineData(BodyPlan.Whale, Explicit = true)]
    public void Every_joint_stays_within_its_limits_whatever_is_asked(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            var body = new StrokeSubject(creature);
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var state = default(SwimState);
            for (int i = 0; i < 600; i++)
            {
                SwimMotion.Update(profile, Wild(profile, i / 60.0), ref state, 1 / (30 * profile.CruiseFrequency), body.Local);
                body.AssertWithinLimits(FormattableString.Invariant($"{plan} {creature.Blueprint.Seed} step {i}"));
            }
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    [InlineData(BodyPlan.Whale)]
    public void A_swimmer_bends_with_its_beat_while_it_gets_faster_and_then_no_longer(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            var body = new StrokeSubject(creature);
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var input = new SwimInput(profile.CruiseSpeed);
            SwimState state = default;
            double most = 0;
            for (int i = 0; i < 120; i++)
            {
                SwimMotion.Update(profile, input, ref state, 1 / (60 * profile.CruiseFrequency), body.Local);
                most = Math.Max(most, state.Stroke.Value);
            }

            Assert.InRange(most, 0.5, 1);
            Assert.InRange(Steady(profile, input, body).Stroke.Value, 0, 1e-3);
        }
    }

    /// <summary>A swimmer that is asked to be slower lets itself glide: its tail does not beat as hard as its speed alone would ask.</summary>
    [Theory]
    [MemberData(nameof(Plans))]
    public void A_swimmer_that_slows_down_glides(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            var body = new StrokeSubject(creature);
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            SwimState cruise = Steady(profile, new SwimInput(profile.CruiseSpeed), body);
            SwimState gliding = cruise;
            float cycle = 1 / profile.CruiseFrequency;
            for (int i = 0; i < 60; i++)
            {
                SwimMotion.Update(profile, default, ref gliding, cycle / 60, body.Local);
            }

            // It still goes at a part of its speed, and beats by less than that part.
            double speed = gliding.Speed / cruise.Speed;
            Assert.InRange(speed, 0.1, 1);
            Assert.True(gliding.BeatFrequency * gliding.BeatAmplitude < 0.6 * speed * cruise.BeatFrequency * cruise.BeatAmplitude, $"{plan} {creature.Blueprint.Seed}: {speed} of the speed, beats {gliding.BeatFrequency} of {cruise.BeatFrequency}, {gliding.BeatAmplitude} of {cruise.BeatAmplitude} wide");
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void The_strouhal_number_lies_between_a_fifth_and_two_fifths(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            foreach (float cruises in new[] { 0.4f, 0.7f, 1f, 1.6f, 2.4f })
            {
                var body = new StrokeSubject(creature);
                var input = new SwimInput(cruises * profile.CruiseSpeed);
                SwimState state = Steady(profile, input, body);
                (double low, double high) = (double.MaxValue, double.MinValue);
                int tip = plan == BodyPlan.Flipper ? FinTip(creature) : creature.Skeleton.IndexOf("TailEnd");
                for (int i = 0; i < 200; i++)
                {
                    SwimMotion.Update(profile, input, ref state, 1 / (200 * state.BeatFrequency), body.Local);
                    body.ToModel();
                    double at = plan is BodyPlan.Whale or BodyPlan.Flipper ? body.ModelPositions[tip].Y : body.ModelPositions[tip].X;
                    low = Math.Min(low, at);
                    high = Math.Max(high, at);
                }

                double strouhal = state.BeatFrequency * (high - low) / input.Speed;
                Assert.True(strouhal is > 0.19 and < 0.42, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed} at {cruises} cruises: {strouhal}"));
            }
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    [InlineData(BodyPlan.Whale)]
    public void The_head_moves_far_less_than_the_tail(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new SwimInput(profile.CruiseSpeed);
            SwimState state = Steady(profile, input, body);
            double head = 0;
            double yaw = 0;
            int nose = creature.Skeleton.IndexOf("HeadEnd");
            for (int i = 0; i < 100; i++)
            {
                SwimMotion.Update(profile, input, ref state, 1 / (100 * state.BeatFrequency), body.Local);
                body.ToModel();
                Vector3 moved = body.ModelPositions[nose] - creature.Skeleton.ModelPositions[nose];
                head = Math.Max(head, Math.Abs(plan == BodyPlan.Whale ? moved.Y : moved.X));
                int joint = creature.Skeleton.Parents[nose];
                yaw = Math.Max(yaw, Rotation.Angle(Rotation.Multiply(body.ModelRotations[joint], Rotation.Inverse(creature.Skeleton.ModelRotations[joint]))));
            }

            Assert.True(head < 0.045 * profile.BodyLength, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: nose {head / profile.BodyLength} L"));
            Assert.True(yaw < 0.30, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: head turns {yaw}"));
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void The_spine_lies_on_the_travelling_wave(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new SwimInput(profile.CruiseSpeed);
            SwimState state = Steady(profile, input, body);
            for (int i = 0; i < 40; i++)
            {
                SwimMotion.Update(profile, input, ref state, 1 / (40 * state.BeatFrequency), body.Local);
                body.ToModel();
                PortableMath.SinCos(2 * PortableMath.Pi * state.CyclePhase, out double sine, out double cosine);
                int body0 = profile.Chain.Body;

                // The roll of the body tilts the wave: it is taken back before the comparison.
                Quaternion there = Rotation.Slerp(Lie(profile, state, profile.Chain.BeforeRoot), Lie(profile, state, profile.Chain.BehindRoot), 0.5);
                Quaternion roll = Rotation.Multiply(there, Rotation.Inverse(body.ModelRotations[body0]));
                for (int b = 2; b < profile.Chain.Count; b++)
                {
                    Vector3 at = Rotation.Rotate(roll, body.ModelPositions[profile.Chain.Bones[b].Turn.Joint] - body.ModelPositions[body0]);
                    double wanted = state.BeatAmplitude * (profile.Wave.Displacement(b, cosine, sine) - profile.Wave.Displacement(1, cosine, sine));
                    Assert.True(Math.Abs(at.X - wanted) < 2e-3 * profile.BodyLength, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed} bone {b}: {at.X} for {wanted}"));
                }
            }
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void A_cycle_under_steady_input_closes(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new SwimInput(0.9f * profile.CruiseSpeed, 0.2f, 0.1f);
            SwimState state = Steady(profile, input, body);
            Quaternion[] first = (Quaternion[])body.Rotations.Clone();
            Go(profile, input, ref state, 1 / (double)state.BeatFrequency, 50, body);

            Assert.True(body.Apart(first) < 1e-3, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: {body.Apart(first)}"));
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void Half_a_cycle_later_a_fish_is_its_own_mirror_image(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new SwimInput(profile.CruiseSpeed);
            SwimState state = Steady(profile, input, body);
            Quaternion[] first = (Quaternion[])body.Rotations.Clone();
            Go(profile, input, ref state, 0.5 / state.BeatFrequency, 20, body);

            Assert.True(body.ApartFromMirror(first) < 1e-3, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: {body.ApartFromMirror(first)}"));
        }
    }

    [Theory]
    [InlineData(BodyPlan.Whale)]
    [InlineData(BodyPlan.Flipper)]
    public void Straight_on_whales_and_paddlers_are_symmetric(BodyPlan plan)
    {
        if (plan == BodyPlan.Flipper)
        {
            // The tail of a paddler wags a little, its flippers beat together.
            foreach (Creature creature in StrokeSubject.Of(plan))
            {
                SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
                var body = new StrokeSubject(creature);
                Steady(profile, new SwimInput(profile.CruiseSpeed), body);
                foreach (var limb in creature.Limbs)
                {
                    int j = limb.Joints[0];
                    Quaternion mirrored = Rotation.Mirror(body.Rotations[creature.Skeleton.Mirrors[j]]);
                    Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(body.Rotations[j]), mirrored)) < 1e-3);
                }
            }

            return;
        }

        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            Steady(profile, new SwimInput(profile.CruiseSpeed), body);
            Assert.True(body.ApartFromMirror(body.Rotations) < 1e-3);
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void Frame_rates_agree(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[0];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        Quaternion[]? reference = null;
        Vector3 place = default;
        foreach (int rate in new[] { 30, 60, 144 })
        {
            var body = new StrokeSubject(creature);
            var state = default(SwimState);
            for (int i = 0; i < 6 * rate; i++)
            {
                // What is asked changes on whole seconds.
                int second = i / rate;
                var input = new SwimInput((second % 3) * profile.CruiseSpeed, second % 2 == 0 ? 0.4f : -0.3f, second > 2 ? 0.3f : 0f);
                SwimMotion.Update(profile, input, ref state, 1f / rate, body.Local);
            }

            reference ??= (Quaternion[])body.Rotations.Clone();
            place = place == default ? body.Positions[profile.Chain.Body] : place;
            Assert.True(body.Apart(reference) < 0.01, FormattableString.Invariant($"{plan} at {rate} Hz: {body.Apart(reference)}"));
            Assert.True(Vec.Distance(body.Positions[profile.Chain.Body], place) < 2e-3f * profile.BodyLength);
        }
    }

    [Theory]
    [MemberData(nameof(Plans))]
    public void Changes_of_speed_and_course_have_no_jump_of_angular_velocity(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[1];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        float coarse = Jerk(profile, creature, 120);
        float fine = Jerk(profile, creature, 480);

        // Where velocities are continuous their change in a step shrinks with the step.
        Assert.True(fine < 0.45f * coarse, FormattableString.Invariant($"{plan}: {coarse} at 120 Hz, {fine} at 480 Hz"));
    }

    [Fact]
    public void A_c_start_curls_the_body_turns_it_and_ends()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Fish))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var state = default(SwimState);
            float dt = 0.01f / profile.CruiseFrequency;
            double turned = 0;
            double curl = 0;
            double fastest = 0;
            int steps = 0;
            int nose = creature.Skeleton.Parents[creature.Skeleton.IndexOf("HeadEnd")];
            int tail = creature.Skeleton.Parents[creature.Skeleton.IndexOf("TailEnd")];
            do
            {
                var root = SwimMotion.Update(profile, new SwimInput(0, Escape: EscapeTurn.Left), ref state, dt, body.Local);
                turned += root.YawRate * dt;
                fastest = Math.Max(fastest, root.Linear.Z);
                body.ToModel();
                Quaternion head = Rotation.Multiply(body.ModelRotations[nose], Rotation.Inverse(creature.Skeleton.ModelRotations[nose]));
                Quaternion fin = Rotation.Multiply(body.ModelRotations[tail], Rotation.Inverse(creature.Skeleton.ModelRotations[tail]));
                curl = Math.Max(curl, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(fin), head)));
                body.AssertWithinLimits("C-start");
                Assert.True(++steps < 200, "the C-start does not end");
            }
            while (state.EscapeProgress > 0);
            Assert.InRange(turned, 1.25, 1.35);
            Assert.True(curl > 1.5, FormattableString.Invariant($"curls up by {curl}"));
            Assert.True(fastest > 1.5 * profile.CruiseSpeed);

            // Held down, the trigger starts no second one.
            SwimMotion.Update(profile, new SwimInput(0, Escape: EscapeTurn.Left), ref state, dt, body.Local);
            Assert.Equal(0f, state.EscapeProgress);
        }
    }

    [Fact]
    public void Updates_allocate_nothing()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Fish)[0];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        var state = default(SwimState);
        Assert.Equal(0, MovingPose.Allocated(() => SwimMotion.Update(profile, new SwimInput(1, 0.3f), ref state, 0.01f, body.Local), 200));
    }

    [Fact]
    public void The_same_inputs_give_the_same_bits_and_no_time_changes_nothing()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Eel)[0];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var a = new StrokeSubject(creature);
        var b = new StrokeSubject(creature);
        var sa = default(SwimState);
        var sb = default(SwimState);
        for (int i = 0; i < 100; i++)
        {
            SwimMotion.Update(profile, Wild(profile, i / 20.0), ref sa, 0.016f, a.Local);
            SwimMotion.Update(profile, Wild(profile, i / 20.0), ref sb, 0.016f, b.Local);
        }

        Assert.Equal(a.Rotations, b.Rotations);
        SwimMotion.Update(profile, new SwimInput(3), ref sb, 0f, b.Local);
        Assert.Equal(a.Rotations, b.Rotations);
    }

    [Theory]
    [InlineData(float.NaN, 0f, 0.1f)]
    [InlineData(1f, float.PositiveInfinity, 0.1f)]
    [InlineData(1f, 0f, float.NaN)]
    [InlineData(1f, 0f, -0.1f)]
    public void Numbers_that_are_none_are_refused(float speed, float yaw, float dt)
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Fish)[0];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        Assert.ThrowsAny<ArgumentException>(() =>
        {
            var state = default(SwimState);
            SwimMotion.Update(profile, new SwimInput(speed, yaw), ref state, dt, body.Local);
        });
    }

    [Fact]
    public void After_a_long_pause_the_motion_goes_on()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Fish)[0];
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        var state = default(SwimState);
        SwimMotion.Update(profile, new SwimInput(1), ref state, 1000f, body.Local);
        body.AssertWithinLimits("pause");
        Assert.InRange(state.CyclePhase, 0f, 1f);
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(20)]
    public void Any_size_swims(double scale)
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Fish, BodyPlan.Eel, BodyPlan.Whale, BodyPlan.Flipper })
        {
            Creature creature = StrokeSubject.Find(plan, 1, scale, scale)[0];
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var state = default(SwimState);
            for (int i = 0; i < 60; i++)
            {
                SwimMotion.Update(profile, new SwimInput(profile.CruiseSpeed, 0.1f), ref state, 0.05f / profile.CruiseFrequency, body.Local);
                body.AssertWithinLimits(FormattableString.Invariant($"{plan} at {scale}"));
            }

            body.ToModel();
            foreach (Vector3 p in body.ModelPositions)
            {
                Assert.True(Vec.Length(p) < 5 * profile.BodyLength);
            }
        }
    }

    private static Quaternion Lie(SwimProfile profile, in SwimState state, int bone)
    {
        PortableMath.SinCos(2 * PortableMath.Pi * state.CyclePhase, out double sine, out double cosine);
        return Rotation.FromAxisAngle(Vector3.UnitY, profile.Wave.Heading(bone, state.BeatAmplitude, cosine, sine));
    }

    private static int FinTip(Creature creature)
    {
        int best = -1;
        foreach (var limb in creature.Limbs)
        {
            int tip = limb.Joints[^1];
            best = best < 0 || creature.Skeleton.ModelPositions[limb.Joints[0]].Z > creature.Skeleton.ModelPositions[creature.Skeleton.Parents[creature.Skeleton.Parents[best]]].Z ? tip : best;
        }

        return best;
    }
}
