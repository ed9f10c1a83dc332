using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Wings;

/// <summary>The edges of a wing at many places, so that the distance from its fingers is quickly found. Immutable.</summary>
internal sealed class WingFingers
{
    private const int Steps = 64;

    private static readonly WingFingers bat = new(BatWing.Form);
    private static readonly WingFingers dragon = new(DragonWing.Form);
    private static readonly WingFingers pterosaur = new(PterosaurWing.Form);
    private static readonly WingFingers glidingLizard = new(GlidingLizardWing.Form);
    private static readonly WingFingers flyingFish = new(FlyingFishWing.Form);

    private readonly WingForm form;
    private readonly float[] lead = new float[Steps + 1];
    private readonly float[] trail = new float[Steps + 1];

    private WingFingers(WingForm form)
    {
        this.form = form;
        for (int i = 0; i <= Steps; i++)
        {
            lead[i] = (float)form.LeadAt(i / (double)Steps);
            trail[i] = (float)form.TrailAt(i / (double)Steps);
        }
    }

    /// <summary>Those of a membrane; null for wings of feathers.</summary>
    public static WingFingers? Of(WingStyle style) => style switch
    {
        WingStyle.Bat => bat,
        WingStyle.Dragon => dragon,
        WingStyle.Pterosaur => pterosaur,
        WingStyle.GlidingLizard => glidingLizard,
        WingStyle.FlyingFish => flyingFish,
        _ => null,
    };

    /// <summary>How far a place is from the nearest finger, in spans.</summary>
    /// <param name="along">Share of the span.</param>
    /// <param name="chord">0 at the leading edge, 1 at the trailing one.</param>
    public float At(float along, float chord) => (float)form.FromFingers(along, Scalar.Lerp(Between(lead, along), Between(trail, along), chord));

    private static float Between(float[] edge, float along)
    {
        float at = Scalar.Clamp(along, 0f, 1f) * Steps;
        int i = Math.Min((int)at, Steps - 1);
        return Scalar.Lerp(edge[i], edge[i + 1], at - i);
    }
}
