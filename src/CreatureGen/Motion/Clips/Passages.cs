using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion.Clips;

/// <summary>What leads a creature from one movement to another and happens once: starting, stopping, jumping, falling, landing, darting.</summary>
internal static class Passages
{
    private const float SettleSeconds = 0.5f;
    private const float LongestStage = 4f;

    /// <summary>Seconds after the last movement, so that what swings comes to rest.</summary>
    private const float Afterwards = 0.5f;

    /// <summary>Metres per second, √(gℓ), below which it stands.</summary>
    private const float Standing = 0.01f;

    /// <summary>Drop from which a landing is recorded, leg lengths; the depth below a fall.</summary>
    private const float Drop = 0.8f;
    private const float Depth = 500f;
    private const float FallSeconds = 1f;

    /// <summary>Speed of a dart in cruises, and its seconds.</summary>
    private const float DartSpeed = 1.6f;
    private const float DartSeconds = 0.6f;

    /// <summary>Part of its reach that a jump goes.</summary>
    private const float JumpPart = 0.7f;

    /// <summary>All that a creature can do.</summary>
    public static IEnumerable<ClipRecipe> Of(MotionProfile profile)
    {
        Movement? goes = Going(profile);
        if (goes != null)
        {
            yield return Recipe("Start", rate => Start(profile, goes, rate));
            yield return Recipe("Stop", rate => Stop(profile, goes, rate));
        }

        if (profile.Legs != null && profile.Gaits != null)
        {
            if (new CreatureAnimator(profile).JumpReach.Speed > 0f)
            {
                yield return Recipe("Jump", rate => Jump(profile, rate));
            }

            if (profile.Flight == null)
            {
                yield return Recipe("Fall", rate => Fall(profile, rate));
                yield return Recipe("Land", rate => Land(profile, rate));
            }
        }

        foreach (Movement movement in Movement.OfGoing(profile))
        {
            if (movement.IsCruise)
            {
                yield return Recipe("Dart", rate => Dart(profile, movement, rate));
            }
        }

        ClipRecipe Recipe(string name, Func<int, Clip> record) => new(name, () => ClipRate.Record(profile.Subject.Skeleton, record));
    }

    /// <summary>What it goes in from standing: the slowest of its ways.</summary>
    private static Movement? Going(MotionProfile profile)
    {
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            if (movement.IsCyclic && movement.Input.Medium == MotionMedium.Ground)
            {
                return movement;
            }
        }

        return null;
    }

    private static CreatureAnimator AtRest(MotionProfile profile, Movement? movement)
    {
        CreatureAnimator animator = movement?.Begin(profile, FlatGround.Level) ?? new CreatureAnimator(profile);
        MotionSettings settings = animator.Settings;
        settings.Idle = 0f;
        animator.Settings = settings;
        animator.Teleport(animator.Root, FlatGround.Level);
        Settle(animator, SettleSeconds, default, FlatGround.Level, _ => false);
        return animator;
    }

    private static void Settle(CreatureAnimator animator, float seconds, in MotionInput input, IGround ground, Func<CreatureAnimator, bool> isOver)
    {
        for (float time = 0f; time < seconds && !isOver(animator); time += 1f / 60f)
        {
            RecordedPassage.Update(animator, input, ground);
        }
    }

    /// <summary>From standing until its cycle begins at full speed, where the clip of the movement begins.</summary>
    private static Clip Start(MotionProfile profile, Movement goes, int rate)
    {
        CreatureAnimator animator = AtRest(profile, goes);
        return new RecordedPassage(animator, rate).Stage(LongestStage, goes.Input, FlatGround.Level, Beginning(0.97f * goes.Input.Speed)).Finish("Start");
    }

    /// <summary>From the beginning of its cycle until it stands.</summary>
    private static Clip Stop(MotionProfile profile, Movement goes, int rate)
    {
        CreatureAnimator animator = AtRest(profile, goes);
        Settle(animator, SteadyMotion.SettleSeconds, goes.Input, FlatGround.Level, _ => false);
        Settle(animator, LongestStage, goes.Input, FlatGround.Level, Beginning(0f));
        return Rest(new RecordedPassage(animator, rate), animator, default).Finish("Stop");
    }

    private static Clip Jump(MotionProfile profile, int rate)
    {
        CreatureAnimator animator = AtRest(profile, null);
        var jump = new RecordedPassage(animator, rate);
        animator.Jump(animator.Root.Position + new Vector3(0f, 0f, JumpPart * animator.JumpReach.Length));
        jump.Stage(LongestStage, default, FlatGround.Level, now => now.State == BodyState.Landed);
        jump.Stage(LongestStage, default, FlatGround.Level, now => now.State == BodyState.Supported);
        return Rest(jump, animator, default).Finish("Jump");
    }

    /// <summary>In the air over nothing, legs reaching: the game moves it down.</summary>
    private static Clip Fall(MotionProfile profile, int rate)
    {
        CreatureAnimator animator = AtRest(profile, null);
        var below = new FlatGround(new Vector3(0f, -Depth * profile.LegLength, 0f), Vector3.UnitY);
        Settle(animator, LongestStage, default, below, now => now.State == BodyState.Falling);
        return new RecordedPassage(animator, rate).InPlace().Stage(FallSeconds, default, below).Finish("Fall");
    }

    /// <summary>From the touch of the feet after a drop until it stands.</summary>
    private static Clip Land(MotionProfile profile, int rate)
    {
        CreatureAnimator animator = AtRest(profile, null);
        var below = new FlatGround(new Vector3(0f, -Drop * profile.LegLength, 0f), Vector3.UnitY);
        Settle(animator, LongestStage, default, below, now => now.State == BodyState.Falling);
        Settle(animator, LongestStage, default, below, now => now.State != BodyState.Falling);
        var landing = new RecordedPassage(animator, rate);
        landing.Stage(LongestStage, default, below, now => now.State == BodyState.Supported);
        return Rest(landing, animator, default, below).Finish("Land");
    }

    /// <summary>Shoots ahead out of hovering or rest, and stands in the air or water again.</summary>
    private static Clip Dart(MotionProfile profile, Movement cruises, int rate)
    {
        bool flies = cruises.Input.Medium == MotionMedium.Air;
        FlatGround at = flies ? new FlatGround(new Vector3(0f, -Depth, 0f), Vector3.UnitY) : FlatGround.Level;
        MotionInput still = cruises.Input with { Speed = 0f };
        CreatureAnimator animator = AtRest(profile, null);
        animator.Teleport(animator.Root, at);
        Settle(animator, SteadyMotion.SettleSeconds, still, at, _ => false);
        var dart = new RecordedPassage(animator, rate);
        dart.Stage(DartSeconds, still with { Speed = DartSpeed * cruises.Input.Speed }, at);
        return Rest(dart, animator, still, at).Finish("Dart");
    }

    private static RecordedPassage Rest(RecordedPassage recorded, CreatureAnimator animator, in MotionInput input, IGround? ground = null)
    {
        float still = Standing * (float)Math.Sqrt(Math.Max(animator.Profile.LegLength, 0.1f) * StandardGravity.Acceleration);
        ground ??= FlatGround.Level;
        return recorded.Stage(LongestStage, input, ground, now => Math.Abs(now.Speed) < still).Stage(Afterwards, input, ground);
    }

    /// <summary>Tells when a cycle begins, of a creature that goes so fast.</summary>
    private static Func<CreatureAnimator, bool> Beginning(float speed)
    {
        float before = 0f;
        return animator =>
        {
            bool begins = animator.Phase < before - 0.5f && animator.Speed >= speed;
            before = animator.Phase;
            return begins;
        };
    }
}
