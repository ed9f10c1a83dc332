using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>What settings make of the bones of a rig, worked out once and not with each update. Apart from what is remembered of each creature: all of a kind share it.</summary>
internal sealed class SpringTuning
{
    private readonly SpringRig rig;
    private readonly SpringTone[] bones;
    private ChainCurve frequency;
    private ChainCurve ratio;
    private ChainCurve radius;
    private ChainCurve drag;
    private ChainCurve fraction;
    private float swing;
    private float speed;

    /// <summary>Works it out.</summary>
    public SpringTuning(SpringRig rig, in SpringSettings settings)
    {
        this.rig = rig;
        bones = new SpringTone[rig.Joints.Length];
        Take(settings);
    }

    /// <summary>Of each joint of the rig, in its order.</summary>
    public ReadOnlySpan<SpringTone> Bones => bones;

    /// <summary>Cosine of the most that a bone swings from its goal.</summary>
    public float SwingCosine { get; private set; }

    /// <summary>Its sine.</summary>
    public float SwingSine { get; private set; }

    /// <summary>The greatest offset of a tip from its goal, lengths of its bone.</summary>
    public float Width { get; private set; }

    /// <summary>Whether it was worked out for these settings.</summary>
    public bool Is(in SpringSettings settings) =>
        drag.Is(settings.Drag) && fraction.Is(settings.GravityFraction) && radius.Is(settings.Radius) && frequency.Is(settings.Frequency) && ratio.Is(settings.DampingRatio) && swing == settings.MaxSwing && speed == settings.MaxSpeed;

    /// <summary>Works it out anew. Only for one that nobody shares.</summary>
    public void Take(in SpringSettings settings)
    {
        frequency = settings.Frequency;
        ratio = settings.DampingRatio;
        radius = settings.Radius;
        drag = settings.Drag;
        fraction = settings.GravityFraction;
        swing = settings.MaxSwing;
        speed = settings.MaxSpeed;
        PortableMath.SinCos(swing, out double sine, out double cosine);
        SwingSine = (float)sine;
        SwingCosine = (float)cosine;
        Width = (float)Math.Sqrt(2 * (1 - cosine));
        for (int i = 0; i < bones.Length; i++)
        {
            float along = rig.Places[i];
            float cycles = Math.Max(frequency.At(along), 0f);
            double fastest = cycles * PortableMath.Tau * speed;
            bones[i] = new SpringTone(
                new DampedSpring((float)(cycles * PortableMath.Tau), Math.Max(ratio.At(along), 0f), SpringBones.Substep),
                cycles > 0f && fastest < 1e9 ? (float)(fastest * fastest) : float.PositiveInfinity,
                Damping.Left(Math.Max(drag.At(along), 0f), SpringBones.Substep),
                fraction.At(along),
                Math.Max(radius.At(along), 0f));
        }
    }
}
