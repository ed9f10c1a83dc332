namespace CreatureGen.Anatomy.Beaks;

/// <summary>One half of a beak as numbers. Thicknesses are in mean radii of the face's section, at the root, in the middle and at the nose.</summary>
internal sealed record BillForm
{
    /// <summary>How far the horn stands off the face along its middle line.</summary>
    public (float Root, float Middle, float Nose) Ridge { get; init; } = (0.07f, 0.1f, 0.1f);

    /// <summary>The same along its sides.</summary>
    public (float Root, float Middle, float Nose) Side { get; init; } = (0.05f, 0.07f, 0.07f);

    /// <summary>How sharp the middle line is: half the breadth of its ridge, segments.</summary>
    public float Keel { get; init; } = 2.5f;

    /// <summary>How far the edge between horn and skin draws forward on the sides, rings.</summary>
    public float Notch { get; init; } = 0.9f;

    /// <summary>How the part beyond the nose closes in breadth and in height: 1 evenly, as a cone does; 2 round; more in a blunt edge.</summary>
    public (float Breadth, float Height) Close { get; init; } = (1.2f, 1.2f);
}
