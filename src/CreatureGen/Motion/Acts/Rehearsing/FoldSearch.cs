using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>
/// Finds where the legs of a body go that lies on its belly: from a few ways of folding that animals have, one number after the other a step to and fro, kept where skin is less deep in the ground and feet are nearer to it.
/// Based on: R. Hooke and T. A. Jeeves, "Direct search solution of numerical and statistical problems" (1961).
/// </summary>
internal static class FoldSearch
{
    private const int Sweeps = 9;
    private const float FirstStep = 0.3f;
    private const float LastStep = 0.03f;

    /// <summary>How far a body comes down at the least, and in which steps, parts of its belly's height; and how deep the skin may be, parts of the body's length.</summary>
    private const float MinDown = 0.65f;
    private const float DownStep = 0.1f;
    private const float MaxSunk = 0.009f;

    /// <summary>How far the chest of an upright body is propped up that lies on its belly, radians.</summary>
    private const float Propped = 0.12f;

    /// <summary>In which steps it is sought how far a body rolls over, radians.</summary>
    private const float TurnStep = 0.05f;

    /// <summary>Finds it for all legs, those of a pair alike.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="stage">Where it is tried.</param>
    /// <param name="legs">Receives it; the stage shows it.</param>
    /// <returns>What the legs cost as they are found so far, one sweep over the numbers of a pair a step.</returns>
    public static IEnumerable<float> Steps(ActBody body, ActStage stage, FoldedLegs legs)
    {
        foreach (float cost in Folded(body, stage, legs))
        {
            yield return cost;
        }

        foreach (float cost in body.Build == BodyBuild.Upright ? Stretched(body, stage, legs) : [])
        {
            yield return cost;
        }

        foreach (float cost in (body.Has & ActNeeds.Back) != 0 ? DrawnIn(body, stage, legs) : [])
        {
            yield return cost;
        }

        foreach (float height in OnFlank(body, stage, legs))
        {
            yield return height;
        }
    }

    /// <summary>How far a body with its legs stretched out rolls over onto its flank or its back until it lies lowest: there it rests. One that would have to climb for it does not stay there.</summary>
    private static IEnumerable<float> OnFlank(ActBody body, ActStage stage, FoldedLegs legs)
    {
        if ((body.Has & (ActNeeds.Flanks | ActNeeds.Back)) == 0)
        {
            yield break;
        }

        // The legs of an upright one are stretched out behind it on its belly, and stay so.
        bool isUpright = body.Build == BodyBuild.Upright;
        LyingSide side = body.LyingSide;
        legs.Tip = side == LyingSide.Back ? Elevation(body, stage) : legs.Tip;
        var values = new float[Act.ChannelCount];
        values[(int)ActChannel.ForeDown] = values[(int)ActChannel.HindDown] = values[(int)ActChannel.ForeFold] = 1f;
        values[(int)ActChannel.HindFold] = isUpright ? 0f : 1f;
        stage.Show(values);
        float lowest = side.MaxRise * Height();
        values[(int)ActChannel.ForeDown] = values[(int)ActChannel.HindDown] = side.Down;
        values[(int)ActChannel.Up] = side.AwayFromFeet;
        values[(int)ActChannel.ForeFold] = isUpright ? 1f : 0f;
        values[(int)ActChannel.HindFold] = 0f;
        values[(int)ActChannel.ForeFeetPitch] = values[(int)ActChannel.HindFeetPitch] = LyingSide.ToesDown;
        values[(int)ActChannel.OnFlank] = 1f;
        float best = 0f;
        for (float turn = side.Nearest; turn < side.Farthest; turn += TurnStep)
        {
            legs.Flank = turn;
            stage.Show(values);
            float height = Height();
            best = height < lowest ? turn : best;
            lowest = Math.Min(lowest, height);
            yield return lowest;
        }

        legs.Flank = best;

        // Nothing brings it to the ground as long as this is not found.
        float Height() => (0.5f * (stage.Model.Positions[body.Body].Y + stage.Model.Positions[body.Spine[^1]].Y)) - body.BearingSkin.Lowest(stage.Model);
    }

    /// <summary>How far the trunk tips over until it is level, and where the legs are then.</summary>
    private static IEnumerable<float> Stretched(ActBody body, ActStage stage, FoldedLegs legs)
    {
        var values = new float[Act.ChannelCount];
        legs.Tip = Elevation(body, stage) - Propped;
        values[(int)ActChannel.HindDown] = 1f;
        values[(int)ActChannel.ForeFold] = 1f;
        return Pairs(body, _ => FoldManner.Stretched, pair => new FoldOnGround(body, stage, legs.Stretched, pair, values));
    }

    /// <summary>Where legs out to the sides are as a body rolls over: as little as they can out of the outline of its trunk.</summary>
    private static IEnumerable<float> DrawnIn(ActBody body, ActStage stage, FoldedLegs legs) =>
        Pairs(body, leg => FoldManner.DrawnInFrom(leg, body.Legs!.Rows, FoldToTrunk.Folded(body, leg, legs)), pair => new FoldToTrunk(body, stage, legs, pair));

    /// <summary>How far a trunk points up as it stands, radians.</summary>
    private static float Elevation(ActBody body, ActStage stage)
    {
        stage.Show(new float[Act.ChannelCount]);
        Vector3 trunk = stage.Model.Positions[body.Spine[^1]] - stage.Model.Positions[body.Skeleton.Parents[body.Spine[0]]];
        return (float)PortableMath.Atan2(trunk.Y, trunk.Z);
    }

    private static IEnumerable<float> Folded(ActBody body, ActStage stage, FoldedLegs legs)
    {
        var values = new float[Act.ChannelCount];
        values[(int)ActChannel.ForeFold] = body.Build == BodyBuild.Upright ? 0f : 1f;
        values[(int)ActChannel.HindFold] = 1f;

        // Legs that do not fold so far carry the body higher; an upright one only squats on them, on its way down.
        for (float down = body.Build == BodyBuild.Upright ? Squat.HindDown : 1f; down > MinDown; down -= DownStep)
        {
            values[(int)ActChannel.ForeDown] = down;
            values[(int)ActChannel.HindDown] = down;
            foreach (float cost in Pairs(body, leg => FoldManner.Of(leg, body.Legs!.Rows), pair => new FoldOnGround(body, stage, legs.Folded, pair, values)))
            {
                yield return cost;
            }

            stage.Show(values);
            if (stage.Sunk() <= MaxSunk)
            {
                yield break;
            }
        }
    }

    /// <summary>Finds where the legs of each pair go.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="manner">How a leg may go.</param>
    /// <param name="trial">What is tried with a left leg and its right one.</param>
    private static IEnumerable<float> Pairs(ActBody body, Func<LegRig, FoldManner> manner, Func<(int Left, int Right), FoldTrial> trial)
    {
        for (int leg = 0; leg < body.Legs!.Legs.Length; leg++)
        {
            LegRig rig = body.Legs.Legs[leg];
            int other = Array.FindIndex(body.Legs.Legs, one => one.Row == rig.Row && one.Side == Side.Right);
            if (rig.Side == Side.Left && other >= 0)
            {
                foreach (float cost in Pair(trial((leg, other)), manner(rig)))
                {
                    yield return cost;
                }
            }
        }
    }

    private static IEnumerable<float> Pair(FoldTrial trial, FoldManner manner)
    {
        var best = new float[FoldManner.Count];
        var now = new float[FoldManner.Count];
        float min = float.MaxValue;
        foreach (float[] beginning in manner.Beginnings)
        {
            beginning.CopyTo(now, 0);
            float cost = trial.Cost(now);
            float step = FirstStep;
            for (int sweep = 0; sweep < Sweeps && step > LastStep; sweep++)
            {
                bool better = false;
                for (int number = 0; number < FoldManner.Count; number++)
                {
                    better |= Move(number, step) || Move(number, -step);
                }

                step = better ? step : 0.5f * step;
                yield return cost;
            }

            cost = trial.Settle(now, cost);
            if (cost < min)
            {
                min = cost;
                now.CopyTo(best, 0);
            }

            bool Move(int number, float by)
            {
                float before = now[number];
                now[number] = Scalar.Clamp(before + by, manner.Min[number], manner.Max[number]);
                float tried = trial.Cost(now);
                if (tried < cost - 1e-4f)
                {
                    cost = tried;
                    return true;
                }

                now[number] = before;
                return false;
            }
        }

        trial.Set(best);
    }
}
