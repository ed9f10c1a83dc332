using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>What an act goes for where nobody says.</summary>
internal static class UsualTarget
{
    /// <summary>How far below level a snout points at the least that goes for the ground, radians.</summary>
    private const float GroundedSnout = 0.6f;

    /// <summary>Height of what is eaten off the ground, units.</summary>
    private const float FoodHeight = 0.03f;

    // Where a hand strikes, arms from its shoulder.
    private static readonly Vector3 acrossAndAhead = new(-0.2f, -0.1f, 0.85f);

    // Where the mouth may meet the ground, units ahead of where it is.
    private static readonly float[] places = { 0f, -0.25f, 0.25f, -0.5f, 0.5f };

    // Parts of the distance at which a snap is tried, the farthest first.
    private static readonly float[] parts = { 1f, 0.7f, 0.45f, 0.25f };

    /// <summary>The target, model space: nothing while it is sought, one way of the trunk a step, then where it is.</summary>
    public static IEnumerable<Vector3?> Steps(Act act, ActBody body, ActStage stage)
    {
        stage.Show(act, 0, 0, ActGain.Full, default);
        Vector3 now = stage.PlaceOf(act.Tool, false);
        if (act.Tool is ActTool.Mouth or ActTool.Brow)
        {
            bool grounded = act.SnoutDown > GroundedSnout && (body.Legs != null || body.Build == BodyBuild.Legless);
            return grounded ? OnGround(act, body, stage, now) : InFront(act, body, stage, now);
        }

        return new Vector3?[] { Beside(act.Tool, body, now) };
    }

    private static Vector3 Beside(ActTool tool, ActBody body, Vector3 now)
    {
        float unit = body.Unit;
        return tool switch
        {
            ActTool.ForeFoot => now + ((body.Build is BodyBuild.Sprawling or BodyBuild.ManyLegged ? new Vector3(-0.05f, 0.28f, 0.3f) : new Vector3(-0.12f, 0.52f, 0.62f)) * unit),
            ActTool.HindFoot => now + (new Vector3(0f, body.Legs!.IsBiped ? 0.4f : 0.5f, body.Legs.IsBiped ? 0.45f : -0.55f) * unit),
            ActTool.Hand => BeforeShoulder(body),
            _ => Vec.Lerp(now, new Vector3(0f, 1.2f * unit, body.Skeleton.ModelPositions[Math.Max(body.Head, 0)].Z), 0.5f),
        };
    }

    /// <summary>Ahead of the shoulder and a little across, as far as an arm that is all but straight.</summary>
    private static Vector3 BeforeShoulder(ActBody body)
    {
        int[] arm = body.Tools.ArmOf(false);
        float reach = 0f;
        for (int i = 1; i < arm.Length; i++)
        {
            reach += Vec.Distance(body.Skeleton.ModelPositions[arm[i - 1]], body.Skeleton.ModelPositions[arm[i]]);
        }

        return body.Skeleton.ModelPositions[arm[0]] + (acrossAndAhead * reach);
    }

    /// <summary>As far in front as it reaches, of a few distances.</summary>
    private static IEnumerable<Vector3?> InFront(Act act, ActBody body, ActStage stage, Vector3 now)
    {
        Vector3 way = (act.Kind == ActKind.Upkeep && body.Build == BodyBuild.Legless ? new Vector3(0f, 0.15f, -0.3f) : Before(body.Build)) * body.Unit;
        foreach (float part in parts)
        {
            var aim = new ActAim(act.Tool, false, now + (way * part), act.SnoutDown, default);
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

        yield return now + (way * parts[^1]);
    }

    /// <summary>What a mouth snaps at, units from where it is: ahead; of crawlers above where the head lies; of what is in the air far ahead, as it flies there.</summary>
    private static Vector3 Before(BodyBuild build) => build switch
    {
        BodyBuild.Legless => new Vector3(0f, 0.6f, -0.55f),
        BodyBuild.Sprawling or BodyBuild.ManyLegged => new Vector3(0f, -0.02f, 0.2f),
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
