using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Legs of a body that lies on its belly: on the ground, neither in it nor off it.</summary>
internal sealed class FoldOnGround : FoldTrial
{
    // What skin in the ground and legs off it cost, for each leg length.
    private const float SunkCost = 12f;
    private const float FloatingCost = 2f;

    /// <summary>Sine of how far out to the side a foot of a leg below its body lies from its hip, along the hinge of its knee, from which on that costs, and what: no bend of the knee brings it there, and as it comes back the plane of its leg turns round at once.</summary>
    private const float FarAside = 0.9f;
    private const float AsideCost = 8f;

    /// <summary>What a foot above the ground costs, for each leg length: the rest of its leg may lie on it already.</summary>
    private const float HeldCost = 0.7f;

    // What a knee above the ground costs, and a leg that is stretched whole, where it is out to the side: where its foot stands it would arch over the ground like a stilt beside a belly that lies there, and flat out it would be a splayed one.
    private const float KneeCost = 0.8f;
    private const float StretchCost = 0.5f;

    private readonly BonePoints foot;

    public FoldOnGround(ActBody body, ActStage stage, FootWays ways, (int Left, int Right) pair, float[] values)
        : base(body, stage, ways, pair, values, new float[FoldManner.Count]) => foot = body.Skin.Of(joint => body.Hangs(joint, Leg.Ball));

    protected override float CostThere(Vector3 asked)
    {
        float lowest = Skin.Lowest(Stage.Model) / Leg.Length;
        return (SunkCost * Math.Max(0f, -lowest)) + (FloatingCost * Math.Max(0f, lowest)) + (FoldManner.IsLaid(Leg) ? Upright() : Aside(asked) + Held());
    }

    /// <summary>How far the foot of a leg below its body is out to the side of its hip. One that is out there already turns about the line to it.</summary>
    private float Aside(Vector3 asked)
    {
        Vector3 chord = asked - Stage.Model.Positions[Leg.Hip];
        float sine = Leg.Lateral ? 0f : Math.Abs(Vec.Dot(chord, Leg.Hinge)) / Math.Max(Vec.Length(chord), 1e-6f);
        return AsideCost * Math.Max(0f, sine - FarAside);
    }

    /// <summary>How far the foot of a leg below its body is off the ground. Pillars fold too little to lie with theirs on it.</summary>
    private float Held() => Body.Build == BodyBuild.Columnar ? 0f : HeldCost * Math.Max(0f, foot.Lowest(Stage.Model)) / Leg.Length;

    /// <summary>What of a leg out to the side is not laid beside the body.</summary>
    private float Upright()
    {
        ReadOnlySpan<Vector3> places = Stage.Model.Positions;
        return (KneeCost * Math.Max(0f, places[Leg.Knee].Y) / Leg.Length) + (StretchCost * Vec.Distance(places[Leg.Hip], places[Leg.Ankle]) / Leg.Reach);
    }
}
