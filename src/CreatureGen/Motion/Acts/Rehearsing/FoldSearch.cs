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

    // What skin in the ground, feet off it, legs that do not get there and feet far from where they stand cost, for each leg length.
    private const float SunkCost = 12f;
    private const float FloatingCost = 2f;
    private const float MissCost = 0.6f;
    private const float WayCost = 0.12f;

    /// <summary>How far the chest of an upright body is propped up that lies on its belly, radians.</summary>
    private const float Propped = 0.12f;

    /// <summary>What a foot costs that its ankle does not let turn as it is asked, for each square of a radian: far beyond its limit it would come round from the other side.</summary>
    private const float TurnCost = 0.15f;

    /// <summary>Sine of how far out to the side a foot of a leg below its body lies from its hip, along the hinge of its knee, from which on that costs, and what: no bend of the knee brings it there, and as it comes back the plane of its leg turns round at once.</summary>
    private const float FarAside = 0.9f;
    private const float AsideCost = 8f;

    /// <summary>In which steps it is sought how far a body rolls over, radians.</summary>
    private const float TurnStep = 0.05f;

    // The same of a knee above the ground, and of a leg that is stretched whole, where it is out to the side: where its foot stands it would arch over the ground like a stilt beside a belly that lies there, and flat out it would be a splayed one.
    private const float KneeCost = 0.8f;
    private const float StretchCost = 0.5f;

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
        return Pairs(body, stage, legs.Stretched, _ => FoldManner.Stretched, values);
    }

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
            foreach (float cost in Pairs(body, stage, legs.Folded, leg => FoldManner.Of(leg, body.Legs!.Rows), values))
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

    private static IEnumerable<float> Pairs(ActBody body, ActStage stage, FootWays ways, Func<LegRig, FoldManner> manner, float[] values)
    {
        for (int leg = 0; leg < body.Legs!.Legs.Length; leg++)
        {
            LegRig rig = body.Legs.Legs[leg];
            int other = Array.FindIndex(body.Legs.Legs, one => one.Row == rig.Row && one.Side == Side.Right);
            if (rig.Side == Side.Left && other >= 0)
            {
                foreach (float cost in Pair(body, stage, ways, manner(rig), (leg, other), values))
                {
                    yield return cost;
                }
            }
        }
    }

    private static IEnumerable<float> Pair(ActBody body, ActStage stage, FootWays ways, FoldManner manner, (int Left, int Right) pair, float[] values)
    {
        (int left, int right) = pair;
        LegRig rig = body.Legs!.Legs[left];
        BonePoints skin = body.Skin.Of(joint => body.Hangs(joint, rig.Hip));
        bool isLaid = FoldManner.IsLaid(rig);
        var best = new float[FoldManner.Count];
        var now = new float[FoldManner.Count];
        float min = float.MaxValue;
        foreach (float[] beginning in manner.Beginnings)
        {
            beginning.CopyTo(now, 0);
            float cost = Cost(now);
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

            if (cost < min)
            {
                min = cost;
                now.CopyTo(best, 0);
            }

            bool Move(int number, float by)
            {
                float before = now[number];
                now[number] = Scalar.Clamp(before + by, manner.Min[number], manner.Max[number]);
                float tried = Cost(now);
                if (tried < cost - 1e-4f)
                {
                    cost = tried;
                    return true;
                }

                now[number] = before;
                return false;
            }
        }

        Set(best);

        void Set(float[] numbers)
        {
            ways.Ways[left] = new Vector3(numbers[1], numbers[2], numbers[0]) * rig.Length;
            ways.Ways[right] = new Vector3(-numbers[1], numbers[2], numbers[0]) * rig.Length;
            ways.Pitches[left] = ways.Pitches[right] = numbers[3];
            ways.Leans[left] = ways.Leans[right] = numbers[4];
        }

        float Cost(float[] numbers)
        {
            Set(numbers);
            stage.Show(values);
            float lowest = skin.Lowest(stage.Model) / rig.Length;
            Vector3 asked = rig.Home + ways.Ways[left] + new Vector3(0f, rig.BallHeight, 0f);
            float miss = Vec.Distance(stage.Model.Positions[rig.Ball], asked) / rig.Length;
            Quaternion foot = Rotation.Multiply(stage.Model.Rotations[rig.Ball], Rotation.Inverse(body.Skeleton.ModelRotations[rig.Ball]));
            float turned = (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(AxisRotation.About(rig.RollAxis, numbers[3])), foot));
            float way = (numbers[0] * numbers[0]) + (numbers[1] * numbers[1]) + (0.1f * numbers[3] * numbers[3]);
            return (SunkCost * Math.Max(0f, -lowest)) + (FloatingCost * Math.Max(0f, lowest)) + (MissCost * miss) + (WayCost * way) + (TurnCost * turned * turned) + (isLaid ? Upright() : Aside(asked));
        }

        // How far the foot of a leg below its body is out to the side of its hip. One that is out there already turns about the line to it.
        float Aside(Vector3 asked)
        {
            Vector3 chord = asked - stage.Model.Positions[rig.Hip];
            float sine = rig.Lateral ? 0f : Math.Abs(Vec.Dot(chord, rig.Hinge)) / Math.Max(Vec.Length(chord), 1e-6f);
            return AsideCost * Math.Max(0f, sine - FarAside);
        }

        // What of a leg out to the side is not laid beside the body.
        float Upright()
        {
            ReadOnlySpan<Vector3> places = stage.Model.Positions;
            return (KneeCost * Math.Max(0f, places[rig.Knee].Y) / rig.Length) + (StretchCost * Vec.Distance(places[rig.Hip], places[rig.Ankle]) / rig.Reach);
        }
    }
}
