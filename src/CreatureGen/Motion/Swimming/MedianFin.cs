using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>A fin on the midline: the water bends it against the way it moves, and a ripple runs along it.</summary>
internal sealed class MedianFin
{
    private const double RootSway = 0.10;
    private const double TipSway = 0.16;
    private const double JointLag = 0.9;
    private const double RippleWavelength = 0.5;
    private const double IdleRipple = 0.10;
    private const double TurnSway = 0.12;
    private const double FastFold = 0.18;

    private readonly JointRotation[] joints;
    private readonly double along;
    private readonly double up;

    public MedianFin(Skeleton skeleton, LimbChain limb, double along)
    {
        this.along = along;
        up = limb.Kind == LimbKind.Dorsal ? 1 : -1;
        joints = new JointRotation[limb.Joints.Count - 1];
        for (int k = 0; k < joints.Length; k++)
        {
            joints[k] = new JointRotation(skeleton, limb.Joints[k]);
        }
    }

    /// <summary>Writes its joints.</summary>
    public void Write(in Pose local, in SwimStroke stroke)
    {
        for (int k = 0; k < joints.Length; k++)
        {
            double lag = JointLag * k;
            double wave = PortableMath.Sin((2 * PortableMath.Pi * ((along / stroke.Wavelength) - stroke.Phase)) - 1.6 - lag);
            double ripple = PortableMath.Sin((4 * PortableMath.Pi * ((along / RippleWavelength) - stroke.Phase)) - lag);
            double sway = stroke.Sideways * stroke.Amplitude * (k == 0 ? RootSway : TipSway) * wave;
            sway += IdleRipple * (k == 0 ? 0.5 : 1) * stroke.Hover * ripple;
            sway += TurnSway * stroke.Steer;
            double fold = k == 0 ? FastFold * stroke.Fast : 0;
            joints[k].Write(local, Rotation.Multiply(AxisRotation.Roll(up * sway), AxisRotation.Pitch(-up * fold)));
        }
    }
}
