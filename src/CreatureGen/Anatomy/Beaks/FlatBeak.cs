namespace CreatureGen.Anatomy.Beaks;

/// <summary>Ducks: broad, with a rim that laps over the lower bill and a dark nail at its end.</summary>
internal static class FlatBeak
{
    /// <summary>Its form.</summary>
    public static readonly BeakForm Form = new()
    {
        Length = (0.3, 0.46), Hook = 0.3,
        Root = (5.7f, 5.4f, 4.6f),
        Upper = new BillForm { Ridge = (0.07f, 0.09f, 0.1f), Side = (0.05f, 0.1f, 0.14f), Keel = 5f, Notch = 0.5f, Close = (2.4f, 1.6f) },
        Lower = new BillForm { Ridge = (0.04f, 0.06f, 0.06f), Side = (0.03f, 0.05f, 0.05f), Keel = 5f, Notch = 0.3f, Close = (2.4f, 1.6f) },
        LowerLength = 0.8f,
        Nostril = (0.3f, 3.4f),
        TipMark = 0.1f, TipShade = 0.5f,
    };
}
