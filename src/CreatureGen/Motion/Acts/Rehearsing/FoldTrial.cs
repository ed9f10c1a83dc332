using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Tries where the legs of a pair go, by the five numbers of <see cref="FoldManner"/>, and tells what that costs for each leg length.</summary>
internal abstract class FoldTrial
{
    /// <summary>What legs that do not get there cost.</summary>
    private const float MissCost = 0.6f;

    /// <summary>What feet cost for each square of how far they are from where they come from, and of how far they are turned beside that.</summary>
    private const float WayCost = 0.12f;
    private const float PitchCost = 0.012f;

    /// <summary>What a foot costs that its ankle does not let turn as it is asked, for each square of a radian: far beyond its limit it would come round from the other side.</summary>
    private const float TurnCost = 0.15f;

    private readonly FootWays ways;
    private readonly (int Left, int Right) pair;
    private readonly float[] from;

    /// <param name="body">Whose.</param>
    /// <param name="stage">Where it is tried.</param>
    /// <param name="ways">Receives where the feet go.</param>
    /// <param name="pair">The legs.</param>
    /// <param name="values">Of the channels as it is tried.</param>
    /// <param name="from">Where the left foot comes from.</param>
    protected FoldTrial(ActBody body, ActStage stage, FootWays ways, (int Left, int Right) pair, float[] values, float[] from)
    {
        Body = body;
        Stage = stage;
        Values = values;
        Leg = body.Legs!.Legs[pair.Left];
        Skin = body.Skin.Of(joint => body.Hangs(joint, Leg.Hip));
        this.ways = ways;
        this.pair = pair;
        this.from = from;
    }

    protected ActBody Body { get; }

    protected ActStage Stage { get; }

    protected float[] Values { get; }

    /// <summary>The left leg, and its skin.</summary>
    protected LegRig Leg { get; }

    protected BonePoints Skin { get; }

    /// <summary>Where the left foot comes from.</summary>
    protected ReadOnlySpan<float> From => from;

    /// <summary>Has the feet go somewhere.</summary>
    public void Set(ReadOnlySpan<float> numbers)
    {
        ways.Ways[pair.Left] = new Vector3(numbers[1], numbers[2], numbers[0]) * Leg.Length;
        ways.Ways[pair.Right] = new Vector3(-numbers[1], numbers[2], numbers[0]) * Leg.Length;
        ways.Pitches[pair.Left] = ways.Pitches[pair.Right] = numbers[3];
        ways.Leans[pair.Left] = ways.Leans[pair.Right] = numbers[4];
    }

    /// <summary>The numbers by which the foot of a left leg goes where it does.</summary>
    public static float[] NumbersOf(FootWays ways, LegRig leg, int index)
    {
        Vector3 way = ways.Ways[index] / leg.Length;
        return new[] { way.Z, way.X, way.Y, ways.Pitches[index], ways.Leans[index] };
    }

    /// <summary>What that costs; the stage shows it.</summary>
    public float Cost(ReadOnlySpan<float> numbers)
    {
        Set(numbers);
        Stage.Show(Values);
        Vector3 asked = Leg.Home + ways.Ways[pair.Left] + new Vector3(0f, Leg.BallHeight, 0f);
        float miss = Vec.Distance(Stage.Model.Positions[Leg.Ball], asked) / Leg.Length;
        Quaternion ball = Rotation.Multiply(Stage.Model.Rotations[Leg.Ball], Rotation.Inverse(Body.Skeleton.ModelRotations[Leg.Ball]));
        float turned = (float)Rotation.AngleBetween(AxisRotation.About(Leg.RollAxis, numbers[3]), ball);
        float ahead = numbers[0] - from[0];
        float aside = numbers[1] - from[1];
        float pitch = numbers[3] - from[3];
        return (MissCost * miss) + (WayCost * ((ahead * ahead) + (aside * aside))) + (PitchCost * pitch * pitch) + (TurnCost * turned * turned) + CostThere(asked);
    }

    /// <summary>What it costs how the leg lies.</summary>
    /// <param name="asked">Where the left foot should be, model space.</param>
    protected abstract float CostThere(Vector3 asked);

    /// <summary>Looks at the best of a search once more, and may change it.</summary>
    /// <param name="found">Where the feet go.</param>
    /// <param name="cost">What that costs.</param>
    /// <returns>What it costs in all.</returns>
    public virtual float Settle(float[] found, float cost) => cost;
}
