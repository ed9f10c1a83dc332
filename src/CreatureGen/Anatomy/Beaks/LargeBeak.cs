namespace CreatureGen.Anatomy.Beaks;

/// <summary>Toucans and hornbills: high and long, with a keel along the top, an even curve and a dark tip.</summary>
internal static class LargeBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.3, 0.5), Hook = 0.65,
        Root = (5.2f, 5.2f, 4.4f),
        Upper = new BillForm { Ridge = (0.16f, 0.22f, 0.22f), Side = (0.09f, 0.1f, 0.1f), Keel = 2.2f, Notch = 0.4f, Close = (1.6f, 1.5f) },
        Lower = new BillForm { Ridge = (0.08f, 0.1f, 0.1f), Side = (0.06f, 0.06f, 0.06f), Notch = 0.2f, Close = (1.6f, 1.5f) },
        LowerLength = 0.75f,
        Nostril = (0.08f, 3f),
        TipMark = 0.24f, TipShade = 0.2f,
    };
}
