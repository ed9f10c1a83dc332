using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Ways of folding a leg to begin a search with, and bounds of it, five numbers each: ahead, out, up, parts of the leg; toes down, the knee of a leg out to the side ahead, radians.</summary>
/// <param name="Beginnings">The ways.</param>
/// <param name="Min">The least of each number.</param>
/// <param name="Max">The most of each.</param>
internal sealed record FoldManner(float[][] Beginnings, float[] Min, float[] Max)
{
    /// <summary>How many numbers there are.</summary>
    public const int Count = 5;

    /// <summary>How far a leg out to the side lies over at most, radians: a little more than level.</summary>
    private const float MaxLean = 1.9f;

    private static readonly float[] most = { 0.9f, 0.7f, 0.2f, 1.8f, 0f };
    private static readonly float[] asItStands = { 0f, 0f, 0f, 0f, 0f };

    // Where it stands, ahead as a sphinx, far ahead on the heel, the wrist folded and the hoof behind, out to the side.
    private static readonly FoldManner under = new([asItStands, [0.45f, 0f, 0f, 0f, 0f], [0.8f, 0.05f, 0.05f, -0.4f, 0f], [-0.4f, 0f, 0.05f, 1.2f, 0f], [0.15f, 0.4f, 0f, 0.2f, 0f]], [-0.9f, -0.2f, 0f, -0.6f, 0f], most);

    // Laid along the ground beside the body, elbows behind and knees ahead: the foot about where it stands, nearer to the body, or farther back.
    private static readonly FoldManner elbowBehind = new([asItStands, [0.2f, 0f, 0f, 0.3f, -1.2f], [0.2f, -0.2f, 0f, 0.3f, -1.5f], [0f, -0.3f, 0f, 0.3f, -1.2f], [-0.4f, 0f, 0f, 0.3f, -1.2f]], [-0.9f, -0.5f, 0f, -0.6f, -MaxLean], [0.9f, 0.7f, 0f, 1.8f, 0f]);
    private static readonly FoldManner kneeAhead = new([asItStands, [-0.2f, 0f, 0f, 0f, 1.2f], [-0.2f, -0.2f, 0f, 0f, 1.5f], [0f, -0.3f, 0f, 0.3f, 1.2f], [-0.5f, 0f, 0f, 0.3f, 1.2f]], [-0.9f, -0.5f, 0f, -0.6f, 0f], [0.9f, 0.7f, 0f, 1.8f, MaxLean]);

    /// <summary>Stretched out behind a body on its chest.</summary>
    public static FoldManner Stretched { get; } = new([[-0.9f, 0f, 0.05f, 1.4f, 0f]], [-1.3f, -0.1f, 0f, 0.6f, 0f], most);

    // How much farther in and up than where it lies a foot is drawn in, parts of the leg.
    private const float DrawnIn = 0.8f;

    /// <summary>Whether a leg is laid down beside a body that lies instead of folding under it: one out to the side, unless it arches as those of insects do.</summary>
    public static bool IsLaid(LegRig leg) => leg.Lateral && !leg.Traits.Kind.Outline.Jointed;

    /// <summary>How a leg folds under a body that lies on its belly, or beside it.</summary>
    /// <param name="leg">Which.</param>
    /// <param name="rows">How many pairs there are.</param>
    public static FoldManner Of(LegRig leg, int rows) => !IsLaid(leg) ? under : leg.IsHind(rows) ? kneeAhead : elbowBehind;

    /// <summary>The same drawn in to a trunk that rolls over, from where it is folded: a leg that is laid down turns no other way than it lies.</summary>
    /// <param name="leg">Which.</param>
    /// <param name="rows">How many pairs there are.</param>
    /// <param name="folded">Where it is folded.</param>
    public static FoldManner DrawnInFrom(LegRig leg, int rows, float[] folded)
    {
        FoldManner lying = Of(leg, rows);
        float lean = IsLaid(leg) ? 0f : MaxLean;
        return new FoldManner([folded, [0.4f, -0.4f, 0.3f, 0.3f, 0f], [-0.4f, -0.4f, 0.3f, 0.3f, 0f], [0.7f, -0.1f, 0.1f, 0.3f, 0f], [-0.7f, -0.1f, 0.1f, 0.3f, 0f]], [lying.Min[0], lying.Min[1] - DrawnIn, 0f, lying.Min[3], lying.Min[4] - lean], [lying.Max[0], lying.Max[1], DrawnIn, lying.Max[3], lying.Max[4] + lean]);
    }
}
