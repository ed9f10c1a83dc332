using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Slithering;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion;

public sealed class CrawlAndEscapeTests
{
    [Fact]
    public void What_rests_on_the_ground_in_sidewinding_stays_where_it_is()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless, 8))
        {
            CreatureAnimator animator = Crawler(creature, SlitherGait.Sidewinding);
            SlitherProfile profile = animator.Profile.Slither!;
            var input = new MotionInput(profile.CruiseSpeed);
            Walkers.Run(animator, 6f, 60f, input, FlatGround.Level);
            int[] belly = Enumerable.Range(profile.NeckBones + 1, profile.Chain.Count - profile.NeckBones - 3).Select(b => profile.Chain.Bones[b].Turn.Joint).ToArray();
            var began = new Vector3?[belly.Length];
            float slip = 0f;
            float way = 0f;
            int contacts = 0;
            for (int i = 0; i < 960; i++)
            {
                Vector3 before = animator.Root.Position;
                animator.Update(1f / 240f, input, FlatGround.Level);
                way += Vec.Distance(before, animator.Root.Position);
                for (int k = 0; k < belly.Length; k++)
                {
                    Vector3 at = animator.Root.ToWorld(animator.ModelPose.Positions[belly[k]]);
                    bool rests = at.Y - creature.Skeleton.ModelPositions[belly[k]].Y < 0.003f * profile.Wavelength;
                    at.Y = 0f;
                    contacts += rests && began[k] == null ? 1 : 0;
                    began[k] = rests ? began[k] ?? at : null;
                    slip = Math.Max(slip, began[k] is Vector3 from ? Vec.Distance(from, at) : 0f);
                }
            }

            Assert.True(contacts > belly.Length, FormattableString.Invariant($"{creature.Blueprint.Seed}: {contacts} contacts"));
            Assert.True(slip < 0.012f * profile.BodyLength, FormattableString.Invariant($"{creature.Blueprint.Seed}: slips by {slip / profile.BodyLength} body lengths of {way / profile.BodyLength}"));
        }
    }

    [Fact]
    public void A_rectilinear_crawl_swings_nowhere_and_moves_the_belly()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless, 4))
        {
            CreatureAnimator animator = Crawler(creature, SlitherGait.Rectilinear);
            SlitherProfile profile = animator.Profile.Slither!;
            var input = new MotionInput(0.3f * profile.CruiseSpeed);
            Walkers.Run(animator, 2f, 60f, input, FlatGround.Level);
            Vector3 from = animator.Root.Position;
            int middle = profile.Chain.Bones[profile.Chain.Count / 2].Turn.Joint;
            float min = float.MaxValue;
            float max = float.MinValue;
            for (int i = 0; i < 300; i++)
            {
                animator.Update(1f / 60f, input, FlatGround.Level);
                foreach (AxialPoint point in Axis(animator))
                {
                    Assert.True(Math.Abs(point.Model.X) < 1e-3f * profile.BodyLength, FormattableString.Invariant($"{creature.Blueprint.Seed} {point.Name}: {point.Model.X}"));
                }

                min = Math.Min(min, animator.ModelPose.Positions[middle].Y);
                max = Math.Max(max, animator.ModelPose.Positions[middle].Y);
            }

            Assert.Equal(5f * input.Speed, animator.Root.Position.Z - from.Z, 0.02f * input.Speed);
            Assert.InRange((max - min) / profile.Wavelength, 0.002f, 0.02f);
        }
    }

    [Fact]
    public void The_way_of_crawling_changes_under_way_without_a_jump_or_an_allocation()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        float coarse = FastestChange(creature, 60f);
        float fine = FastestChange(creature, 240f);
        Assert.True(fine < 0.4f * coarse, FormattableString.Invariant($"{coarse} rad in 1/60 s, {fine} in 1/240 s"));
        CreatureAnimator animator = Crawler(creature, SlitherGait.Undulating);
        int updates = 0;
        SlitheringSettings[] ways = Enumerable.Range(0, 3).Select(way => animator.Settings.Slithering with { Gait = (SlitherGait)way }).ToArray();
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            MotionSettings settings = animator.Settings;
            settings.Slithering = ways[updates++ / 50 % 3];
            animator.Settings = settings;
            animator.Update(1f / 60f, new MotionInput(animator.Profile.Slither!.CruiseSpeed), FlatGround.Level);
        }, 300));
    }

    [Theory]
    [InlineData(SlitherGait.Sidewinding)]
    [InlineData(SlitherGait.Rectilinear)]
    public void A_crawl_is_the_same_at_any_frame_rate(SlitherGait mode)
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        CreatureAnimator? first = null;
        foreach (float rate in new[] { 30f, 60f, 144f })
        {
            CreatureAnimator animator = Crawler(creature, mode);
            SlitherProfile profile = animator.Profile.Slither!;
            Walkers.Run(animator, 8f, rate, new MotionInput(0.6f * profile.CruiseSpeed, 0.05f), FlatGround.Level);
            first ??= animator;
            Assert.True(Vec.Distance(first.Root.Position, animator.Root.Position) < 5e-3f * profile.BodyLength, FormattableString.Invariant($"{rate} Hz: {first.Root.Position} and {animator.Root.Position}"));
            Assert.True(MaxApart(first, animator) < 0.03, FormattableString.Invariant($"{rate} Hz: {MaxApart(first, animator)} rad"));
        }
    }

    [Fact]
    public void A_way_of_crawling_that_does_not_exist_is_refused()
    {
        var animator = new CreatureAnimator(StrokeSubject.Of(BodyPlan.Legless)[0]);
        MotionSettings settings = animator.Settings;
        settings.Slithering = settings.Slithering with { Gait = (SlitherGait)3 };
        Assert.Contains("Gait", Assert.Throws<ArgumentOutOfRangeException>(() => animator.Settings = settings).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(0.5)]
    [InlineData(4)]
    public void A_startled_fish_bends_to_a_C_in_the_time_of_its_size_turns_as_asked_and_swims_off(double size)
    {
        foreach (Creature creature in StrokeSubject.Find(BodyPlan.Fish, 3, size, size))
        {
            var animator = new CreatureAnimator(creature);
            SwimProfile profile = animator.Profile.Swim!;
            float speed = 0.5f * profile.CruiseSpeed;
            Walkers.Run(animator, 3f / profile.CruiseFrequency, 240f * profile.CruiseFrequency, new MotionInput(speed), FlatGround.Level);
            float step = 1f / (500f * profile.CruiseFrequency);
            float time = 0f;
            float bentAt = 0f;
            float fastest = 0f;
            double bend = 0;
            while (time < 2f / profile.CruiseFrequency)
            {
                animator.Update(step, new MotionInput(speed, Escape: EscapeTurn.Right), FlatGround.Level);
                time += step;
                fastest = Math.Max(fastest, animator.Speed);
                double now = -Bend(animator);
                bentAt = now > bend ? time : bentAt;
                bend = Math.Max(bend, now);
            }

            // Domenici and Blake 1997: first stages of 20 to 40 ms in fish of 5 to 10 cm, longer in longer ones.
            double expected = 0.02 * PortableMath.Pow(profile.BodyLength / 0.05, 0.55);
            Assert.True(bend > 1.2, FormattableString.Invariant($"{size} {creature.Blueprint.Seed}: bends by {bend}"));
            Assert.InRange(bentAt / expected, 0.8, 2.0);
            Vector3 ahead = Rotation.Rotate(animator.Root.Rotation, Vector3.UnitZ);
            Assert.InRange(-PortableMath.Atan2(ahead.X, ahead.Z), 1.29, 1.31);
            Assert.True(fastest > 2f * profile.CruiseSpeed);
            Assert.Equal(speed, animator.Speed, 1e-3f * speed);
            Assert.False(animator.Escapes);
        }
    }

    [Fact]
    public void A_C_start_is_the_same_at_any_frame_rate_and_mirrored_to_the_other_side()
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Fish, BodyPlan.Eel })
        {
            Creature creature = StrokeSubject.Of(plan)[0];
            CreatureAnimator fine = Darted(creature, 960f, EscapeTurn.Left);
            float length = fine.Profile.Swim!.BodyLength;
            foreach (float rate in new[] { 30f, 60f, 144f })
            {
                CreatureAnimator animator = Darted(creature, rate, EscapeTurn.Left);
                Assert.True(Vec.Distance(fine.Root.Position, animator.Root.Position) < 0.01f * length, FormattableString.Invariant($"{plan} {rate} Hz: {Vec.Distance(fine.Root.Position, animator.Root.Position) / length} L"));
                Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(fine.Root.Rotation), animator.Root.Rotation)) < 1e-3);
                Assert.True(MaxApart(fine, animator) < 0.06, FormattableString.Invariant($"{plan} {rate} Hz: {MaxApart(fine, animator)} rad"));
            }

            CreatureAnimator right = Darted(creature, 960f, EscapeTurn.Right);
            Assert.Equal(-fine.Root.Position.X, right.Root.Position.X, 1e-3f * length);
            Assert.Equal(fine.Root.Position.Z, right.Root.Position.Z, 1e-3f * length);
        }
    }

    [Fact]
    public void A_startle_that_is_held_starts_one_C_start_and_one_let_go_may_start_another()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Fish)[0];
        var animator = new CreatureAnimator(creature);
        float whole = 1f / animator.Profile.Swim!.CruiseFrequency;
        int Starts(EscapeTurn turn)
        {
            int starts = 0;
            for (int i = 0; i < 200; i++)
            {
                bool before = animator.Escapes;
                animator.Update(0.01f * whole, new MotionInput(0f, Escape: turn), FlatGround.Level);
                starts += animator.Escapes && !before ? 1 : 0;
            }

            return starts;
        }

        Assert.Equal(1, Starts(EscapeTurn.Left));
        Assert.Equal(0, Starts(EscapeTurn.None));
        Assert.Equal(1, Starts(EscapeTurn.Right));
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            Walkers.Run(animator, 2f * whole, 100f / whole, new MotionInput(0f, Escape: EscapeTurn.Left), FlatGround.Level);
            Walkers.Run(animator, 2f * whole, 100f / whole, default, FlatGround.Level);
        }, 1));
        Assert.ThrowsAny<ArgumentException>(() => animator.Update(0.01f, new MotionInput(float.NaN, Escape: EscapeTurn.Left), FlatGround.Level));
    }

    [Fact]
    public void Creatures_on_legs_take_no_notice()
    {
        Creature creature = Walkers.Of(BodyPlan.Digitigrade, 1);
        var plain = new CreatureAnimator(creature);
        var startled = new CreatureAnimator(creature);
        MotionSettings settings = startled.Settings;
        settings.Slithering = settings.Slithering with { Gait = SlitherGait.Sidewinding };
        startled.Settings = settings;
        Walkers.Run(plain, 1f, 60f, new MotionInput(1f), FlatGround.Level);
        Walkers.Run(startled, 1f, 60f, new MotionInput(1f, Escape: EscapeTurn.Left), FlatGround.Level);
        Assert.Equal(plain.LocalPose.Rotations.ToArray(), startled.LocalPose.Rotations.ToArray());
    }

    [Fact]
    public void Movements_and_clips_know_every_way()
    {
        Creature serpent = StrokeSubject.Of(BodyPlan.Legless)[0];
        Assert.Equal(new[] { "Idle", "Slither", "Sidewind", "Rectilinear" }, Movement.OfGoing(new MotionProfile(serpent)).Select(movement => movement.Name));
        Assert.All(ClipBaker.Bake(serpent), clip => Assert.Equal(ClipEnd.Loops, clip.End));
        Creature fish = StrokeSubject.Of(BodyPlan.Fish)[0];
        Assert.Equal(new[] { "Idle", "Swim", "CStart" }, Movement.OfGoing(new MotionProfile(fish)).Select(movement => movement.Name));
        Assert.DoesNotContain(Movement.OfGoing(new MotionProfile(StrokeSubject.Of(BodyPlan.Whale)[0])), movement => movement.Kind == ClipKind.Escape);
        Clip dart = ClipBaker.Bake(fish).Single(clip => clip.Name == "CStart");
        Assert.Equal(ClipEnd.Stays, dart.End);

        // It stays in place, so the body carries the turn.
        int body = fish.Skeleton.IndexOf("Body");
        Quaternion turn = Rotation.Multiply(dart.RotationsAt(dart.Frames - 1)[body], Rotation.Inverse(dart.RotationsAt(0)[body]));
        Assert.InRange(Rotation.Angle(turn), 1.0, 1.6);
        Assert.Equal(dart.RotationsAt(0)[0], dart.RotationsAt(dart.Frames - 1)[0]);
    }

    private static CreatureAnimator Crawler(Creature creature, SlitherGait mode)
    {
        var animator = new CreatureAnimator(creature);
        MotionSettings settings = animator.Settings;
        settings.Slithering = settings.Slithering with { Gait = mode };
        animator.Settings = settings;
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        return animator;
    }

    private static CreatureAnimator Darted(Creature creature, float rate, EscapeTurn turn)
    {
        var animator = new CreatureAnimator(creature);
        Walkers.Run(animator, 0.5f, rate, default, FlatGround.Level);
        Walkers.Run(animator, 2f, rate, new MotionInput(0f, Escape: turn), FlatGround.Level);
        return animator;
    }

    private static float FastestChange(Creature creature, float rate)
    {
        CreatureAnimator animator = Crawler(creature, SlitherGait.Undulating);
        float speed = animator.Profile.Slither!.CruiseSpeed;
        Quaternion[] before = animator.LocalPose.Rotations.ToArray();
        float max = 0f;
        Walkers.Run(animator, 1f, rate, new MotionInput(speed), FlatGround.Level);
        animator.LocalPose.Rotations.CopyTo(before);
        for (int i = 0; i < 12 * rate; i++)
        {
            MotionSettings settings = animator.Settings;
            settings.Slithering = settings.Slithering with { Gait = (SlitherGait)((int)(i / rate) / 2 % 3) };
            animator.Settings = settings;
            animator.Update(1f / rate, new MotionInput(speed), FlatGround.Level);
            for (int j = 0; j < before.Length; j++)
            {
                bool lid = creature.Skeleton.Joints[j].Role == JointRole.Lid;
                max = lid ? max : Math.Max(max, (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), animator.LocalPose.Rotations[j])));
            }

            animator.LocalPose.Rotations.CopyTo(before);
        }

        return max;
    }

    private static double MaxApart(CreatureAnimator a, CreatureAnimator b)
    {
        double max = 0;
        Skeleton skeleton = a.Profile.Subject.Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            bool eyes = skeleton.Joints[j].Role is JointRole.Lid or JointRole.Eye;
            max = eyes ? max : Math.Max(max, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(a.LocalPose.Rotations[j]), b.LocalPose.Rotations[j])));
        }

        return max;
    }

    /// <summary>How far the head heads to the left of the tail, radians.</summary>
    private static double Bend(CreatureAnimator animator)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        int tail = skeleton.Parents[skeleton.IndexOf("TailEnd")];
        double Heading(int joint)
        {
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(animator.ModelPose.Rotations[joint], Rotation.Inverse(skeleton.ModelRotations[joint])), Vector3.UnitZ);
            return PortableMath.Atan2(ahead.X, ahead.Z);
        }

        double angle = Heading(skeleton.IndexOf("Head")) - Heading(tail);
        return PortableMath.Atan2(PortableMath.Sin(angle), PortableMath.Cos(angle));
    }

    private static IEnumerable<AxialPoint> Axis(CreatureAnimator animator)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            if (skeleton.Joints[j].Role is JointRole.Spine or JointRole.Chest or JointRole.Pelvis or JointRole.Tail or JointRole.Neck or JointRole.Head)
            {
                yield return new AxialPoint(skeleton.Joints[j].Name, animator.ModelPose.Positions[j]);
            }
        }
    }

    private readonly record struct AxialPoint(string Name, Vector3 Model);
}
