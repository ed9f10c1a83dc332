namespace CreatureGen.Motion.Gaits;

/// <summary>The numbers of a gait that pass over smoothly into those of the next one.</summary>
internal struct GaitShape
{
    public float Lift;
    public float Track;
    public float Crouch;
    public float ForceDip;
    public float Bounce;
    public float BounceCap;
    public float Emphasis;
    public float ForeBias;
    public float HindBias;
    public float Lean;
    public float ElbowBend;
    public float Tuck;
    public float Trail;

    public static GaitShape Of(Gait gait) => new()
    {
        Lift = gait.Lift,
        Track = gait.Track,
        Crouch = gait.Crouch,
        ForceDip = gait.ForceDip,
        Bounce = gait.Bounce,
        BounceCap = gait.BounceCap,
        Emphasis = gait.Emphasis,
        ForeBias = gait.ForeBias,
        HindBias = gait.HindBias,
        Lean = gait.Lean,
        ElbowBend = gait.ElbowBend,
        Tuck = gait.Tuck,
        Trail = gait.Trail,
    };

    /// <summary>Goes a share of the way to those of a gait.</summary>
    public void Approach(Gait gait, float share)
    {
        Lift += (gait.Lift - Lift) * share;
        Track += (gait.Track - Track) * share;
        Crouch += (gait.Crouch - Crouch) * share;
        ForceDip += (gait.ForceDip - ForceDip) * share;
        Bounce += (gait.Bounce - Bounce) * share;
        BounceCap += (gait.BounceCap - BounceCap) * share;
        Emphasis += (gait.Emphasis - Emphasis) * share;
        ForeBias += (gait.ForeBias - ForeBias) * share;
        HindBias += (gait.HindBias - HindBias) * share;
        Lean += (gait.Lean - Lean) * share;
        ElbowBend += (gait.ElbowBend - ElbowBend) * share;
        Tuck += (gait.Tuck - Tuck) * share;
        Trail += (gait.Trail - Trail) * share;
    }
}
