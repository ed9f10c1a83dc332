using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>What an act goes for where nobody says.</summary>
internal static class UsualTarget
{
    /// <summary>How far below level a snout points at the least that goes for the ground, radians.</summary>
    private const float GroundedSnout = 0.6f;

    /// <summary>Height of what is eaten off the ground, units.</summary>
    private const float FoodHeight = 0.03f;

    // Where a hand strikes, arms from its shoulder as the trunk has it then.
    private static readonly Vector3 acrossAndAhead = new(-0.1f, -0.25f, 0.74f);

    // Where a tail strikes that comes over the back, and an abdomen that is bent under the body: tails up from its root, and ahead; the farthest first.
    private static readonly (float Up, float Ahead)[] overBack = { (0.3f, 0.6f), (0.4f, 0.45f), (0.5f, 0.3f), (0.55f, 0.15f), (0.6f, 0f) };
    private static readonly (float Up, float Ahead)[] under = { (-0.65f, -0.4f), (-0.6f, -0.6f), (-0.5f, -0.7f), (-0.4f, -0.8f) };

    /// <summary>Height above the ground at the least of what an abdomen stings, units.</summary>
    private const float StungHeight = 0.06f;

    // Where a lowered brow strikes, units from where it is.
    private static readonly Vector3 beforeBrow = new(0f, 0.08f, 0.35f);

    // Where the mouth may meet the ground, units ahead of where it is.
    private static readonly float[] places = { 0f, -0.25f, 0.25f, -0.5f, 0.5f };

    // Where a mouth goes on a fore leg, parts of the way from its joint above the foot to the one over that: the hollow of a foot first.
    private static readonly float[] onLeg = { -0.4f, 0f, 0.4f, 0.7f, 1f };

    /// <summary>How far before the bones of a leg its skin is nibbled, units.</summary>
    private const float SkinOfLeg = 0.06f;

    // Parts of the distance at which a snap is tried, the farthest first.
    private static readonly float[] parts = { 1f, 0.7f, 0.45f, 0.25f };

    /// <summary>The target, model space: nothing while it is sought, one way of the trunk a step, then where it is.</summary>
    public static IEnumerable<Vector3?> Steps(Act act, ActBody body, ActStage stage)
    {
        stage.Show(act, 0, 0, ActGain.Full, default);
        Vector3 now = stage.PlaceOf(act.Tool, false);
        return act.Tool switch
        {
            ActTool.Mouth when act.IsOnItself => FirstReached(act, body, stage, OnForeLeg(act, body, stage)),
            ActTool.Mouth when act.SnoutDown > GroundedSnout && (body.Legs != null || body.Build == BodyBuild.Legless) => OnGround(act, body, stage, now),
            ActTool.Mouth => FirstReached(act, body, stage, InFront(act, body, now)),
            ActTool.Brow => FirstReached(act, body, stage, BeforeBrow(act, body, stage)),
            ActTool.Tail => FirstReached(act, body, stage, AroundTail(act, body)),
            _ => new Vector3?[] { Beside(act, body, stage, now) },
        };
    }

    private static Vector3 Beside(Act act, ActBody body, ActStage stage, Vector3 now)
    {
        float unit = body.Unit;
        return act.Tool switch
        {
            ActTool.ForeFoot => now + ((body.Build is BodyBuild.Sprawling or BodyBuild.ManyLegged ? new Vector3(-0.05f, 0.28f, 0.3f) : new Vector3(-0.12f, 0.52f, 0.62f)) * unit),
            ActTool.HindFoot => now + (new Vector3(0f, 0.5f, body.Legs!.IsBiped ? 0.47f : -0.55f) * unit),
            _ => BeforeShoulder(act, body, stage),
        };
    }

    /// <summary>Ahead of the shoulder and a little across, as far as an arm that is nearly straight.</summary>
    private static Vector3 BeforeShoulder(Act act, ActBody body, ActStage stage)
    {
        stage.Show(act, ReachSearch.ReachedIn(act), 1, ActGain.Full, default);
        int[] arm = body.Tools.ArmOf(false);
        float reach = 0f;
        for (int i = 1; i < arm.Length; i++)
        {
            reach += Vec.Distance(body.Skeleton.ModelPositions[arm[i - 1]], body.Skeleton.ModelPositions[arm[i]]);
        }

        return stage.Model.Positions[arm[0]] + (acrossAndAhead * reach);
    }

    /// <summary>In front of the mouth, at a few distances.</summary>
    private static IEnumerable<Vector3> InFront(Act act, ActBody body, Vector3 now)
    {
        Vector3 way = (act.Kind == ActKind.Upkeep && body.Build == BodyBuild.Legless ? new Vector3(0f, 0.15f, -0.3f) : Before(body.Build)) * body.Unit;
        return parts.Select(part => now + (way * part));
    }

    /// <summary>Up the fore leg of the act's side, from its foot, as the act holds it.</summary>
    private static IEnumerable<Vector3> OnForeLeg(Act act, ActBody body, ActStage stage)
    {
        stage.Show(act, ReachSearch.ReachedIn(act), 1, ActGain.Full, default);
        LegRig leg = body.Legs!.Legs[body.ForeFeet.Left];
        Vector3 ankle = stage.Model.Positions[leg.Ankle];
        Vector3 ball = stage.Model.Positions[leg.Ball];
        Vector3 knee = stage.Model.Positions[leg.Knee];
        return Array.ConvertAll(onLeg, at => (at < 0f ? Vec.Lerp(ankle, ball, -at) : Vec.Lerp(ankle, knee, at)) + new Vector3(0f, 0f, SkinOfLeg * body.Unit));
    }

    /// <summary>Ahead of the brow as it is lowered before it strikes.</summary>
    private static IEnumerable<Vector3> BeforeBrow(Act act, ActBody body, ActStage stage)
    {
        stage.Show(act, Math.Max(act.IndexOf(ActMark.Commit), 0), 1, ActGain.Full, default);
        Vector3 lowered = stage.PlaceOf(act.Tool, false);
        return parts.Select(part => lowered + (beforeBrow * body.Unit * part));
    }

    /// <summary>Over the back, of a tail that is raised before it strikes, else under the body.</summary>
    private static IEnumerable<Vector3> AroundTail(Act act, ActBody body)
    {
        Vector3 root = body.Skeleton.ModelPositions[body.Tail.Joints[0]];
        bool raised = act.Ends[Math.Max(act.IndexOf(ActMark.Commit), 0)][(int)ActChannel.TailPitch] > 0f;
        return (raised ? overBack : under).Select(place =>
        {
            Vector3 target = root + (new Vector3(0f, place.Up, place.Ahead) * body.Tail.Length);
            return target with { Y = Math.Max(target.Y, StungHeight * body.Unit) };
        });
    }

    /// <summary>The first of some places that it reaches, else the last.</summary>
    private static IEnumerable<Vector3?> FirstReached(Act act, ActBody body, ActStage stage, IEnumerable<Vector3> places)
    {
        Vector3 last = default;
        foreach (Vector3 place in places)
        {
            last = place;
            var aim = new ActAim(act.Tool, false, place, act.SnoutDown, default);
            var search = new ReachSearch(stage, body, act, ActGain.Full, aim);
            while (search.Advance())
            {
                yield return null;
            }

            if (search.Missing < 1.5f * ReachSearch.Near * body.Unit)
            {
                yield return aim.Target;
                yield break;
            }
        }

        yield return last;
    }

    /// <summary>What a mouth snaps at, units from where it is: ahead; of crawlers above where the head lies; of what is in the air far ahead, as it flies there.</summary>
    private static Vector3 Before(BodyBuild build) => build switch
    {
        BodyBuild.Legless => new Vector3(0f, 0.6f, -0.55f),
        BodyBuild.Sprawling => new Vector3(0f, -0.02f, 0.2f),
        BodyBuild.ManyLegged => new Vector3(0f, -0.05f, 0.34f),
        BodyBuild.Airborne => new Vector3(0f, -0.1f, 2f),
        _ => new Vector3(0f, -0.12f, 0.4f),
    };

    private static IEnumerable<Vector3?> OnGround(Act act, ActBody body, ActStage stage, Vector3 now)
    {
        Vector3 best = now;
        float min = float.MaxValue;
        foreach (float ahead in places)
        {
            var aim = new ActAim(act.Tool, false, new Vector3(now.X, (FoodHeight * body.Unit) + body.Tools.ChinBelowMouth, now.Z + (ahead * body.Unit)), act.SnoutDown, default);
            var search = new ReachSearch(stage, body, act, ActGain.Full, aim);
            while (search.Advance())
            {
                yield return null;
            }

            if (search.Missing < 0.8f * min)
            {
                min = search.Missing;
                best = aim.Target;
            }

            if (search.Missing < 2f * ReachSearch.Near * body.Unit)
            {
                break;
            }
        }

        yield return best;
    }
}
