namespace CreatureGen.Anatomy.Beaks;

/// <summary>What a beak is made of as numbers. It lies on the face like a sheath and goes on beyond it to a tip of its own.</summary>
internal sealed record BeakForm
{
    /// <summary>How far the tip is ahead of the nose, in half heights of the head: least and most.</summary>
    public (double Min, double Max) Length { get; init; }

    /// <summary>How far the beak turns down from the nose to its tip, radians.</summary>
    public double Hook { get; init; }

    /// <summary>Ring of the body's grid at which the horn begins along the top, along the lips and along the chin.</summary>
    public (float Top, float Lip, float Chin) Root { get; init; } = (5.6f, 5.6f, 4.6f);

    /// <summary>The upper bill.</summary>
    public BillForm Upper { get; init; } = new();

    /// <summary>The lower bill.</summary>
    public BillForm Lower { get; init; } = new();

    /// <summary>How far ahead the lower bill ends, in lengths of the upper one from the nose.</summary>
    public float LowerLength { get; init; } = 0.85f;

    /// <summary>Share of the upper bill from its root to the nose that soft skin covers, the cere; 0 for none.</summary>
    public float Cere { get; init; }

    /// <summary>Where nostrils are: share of the way from the root to the nose, and segment.</summary>
    public (float Along, float Segment) Nostril { get; init; } = (0.34f, 4.4f);

    /// <summary>Share of the beak's length, from its tip back, that has another shade; 0 for none.</summary>
    public float TipMark { get; init; }

    /// <summary>Factor on the colour of that share.</summary>
    public float TipShade { get; init; } = 0.5f;

    /// <summary>The form of a style.</summary>
    public static BeakForm Of(BeakStyle style) => style switch
    {
        BeakStyle.Hooked => HookedBeak.Form,
        BeakStyle.Probe => ProbeBeak.Form,
        BeakStyle.Flat => FlatBeak.Form,
        BeakStyle.Parrot => ParrotBeak.Form,
        BeakStyle.Large => LargeBeak.Form,
        _ => ConicalBeak.Form,
    };
}
