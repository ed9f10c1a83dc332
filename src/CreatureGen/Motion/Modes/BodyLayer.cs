using System;
using System.Numerics;

namespace CreatureGen.Motion.Modes;

/// <summary>What an act or a mood asks of trunk, feet and wings on top of a way of moving, before the legs are solved: feet that stand stay where they are. Model space, metres, radians; + is to the left, up, ahead, nose up.</summary>
internal sealed class BodyLayer
{
    /// <summary>A layer that asks nothing of so many feet.</summary>
    public BodyLayer(int feet) => Feet = new FootLayer[feet];

    /// <summary>How far the trunk goes, metres.</summary>
    public Vector3 Way { get; set; }

    /// <summary>Turn of the trunk to the left.</summary>
    public float Yaw { get; set; }

    /// <summary>Nose up, about the hips; nose down, about the shoulders, so that the other end is lifted.</summary>
    public float Pitch { get; set; }

    /// <summary>Its left side up.</summary>
    public float Roll { get; set; }

    /// <summary>How far the chest comes down, metres. Of bodies on two legs it only bows.</summary>
    public float ForeDown { get; set; }

    /// <summary>How far the hips come down, metres.</summary>
    public float HindDown { get; set; }

    /// <summary>Bend of the back from the hips to the chest.</summary>
    public float BackPitch { get; set; }

    /// <summary>The same to the left.</summary>
    public float BackSide { get; set; }

    /// <summary>The same about its own length, left side up.</summary>
    public float BackTwist { get; set; }

    /// <summary>Bend of the front of a body on many pairs of legs up from the ground, with its feet; above 0.</summary>
    public float FrontPitch { get; set; }

    /// <summary>The same to the left, where it is raised.</summary>
    public float FrontSide { get; set; }

    /// <summary>How far folded wings are spread and raised, 0..1; beyond 1 raised higher. Of wings that are spread, only raised.</summary>
    public float Wings { get; set; }

    /// <summary>How far it puts off shifting its weight and breathing, 0..1.</summary>
    public float Still { get; set; }

    /// <summary>How springy its steps are: swinging feet go higher, and the body rises and falls more, by so many parts; less below 0, at least −1.</summary>
    public float Verve { get; set; }

    /// <summary>What is asked of each foot.</summary>
    public FootLayer[] Feet { get; }

    /// <summary>Asks nothing.</summary>
    public void Clear()
    {
        Way = Vector3.Zero;
        Yaw = Pitch = Roll = 0f;
        ForeDown = HindDown = 0f;
        BackPitch = BackSide = BackTwist = 0f;
        FrontPitch = FrontSide = 0f;
        Wings = Still = Verve = 0f;
        Array.Clear(Feet, 0, Feet.Length);
    }

    /// <summary>Asks for what another asks as well, but where feet are to be instead of their places.</summary>
    /// <param name="other">Of as many feet; null asks nothing.</param>
    public void Add(BodyLayer? other)
    {
        if (other == null)
        {
            return;
        }

        Way += other.Way;
        Yaw += other.Yaw;
        Pitch += other.Pitch;
        Roll += other.Roll;
        ForeDown += other.ForeDown;
        HindDown += other.HindDown;
        BackPitch += other.BackPitch;
        BackSide += other.BackSide;
        BackTwist += other.BackTwist;
        FrontPitch += other.FrontPitch;
        FrontSide += other.FrontSide;
        Wings += other.Wings;
        Still = Math.Max(Still, other.Still);
        Verve += other.Verve;
        for (int i = 0; i < Feet.Length; i++)
        {
            Feet[i].Way += other.Feet[i].Way;
            Feet[i].Pitch += other.Feet[i].Pitch;
            Feet[i].Lean += other.Feet[i].Lean;
            Feet[i].Loose = Math.Max(Feet[i].Loose, other.Feet[i].Loose);
            Feet[i].Carried = Math.Max(Feet[i].Carried, other.Feet[i].Carried);
        }
    }

    /// <summary>Takes over what another of as many feet asks.</summary>
    public void CopyFrom(BodyLayer other)
    {
        Way = other.Way;
        Yaw = other.Yaw;
        Pitch = other.Pitch;
        Roll = other.Roll;
        ForeDown = other.ForeDown;
        HindDown = other.HindDown;
        BackPitch = other.BackPitch;
        BackSide = other.BackSide;
        BackTwist = other.BackTwist;
        FrontPitch = other.FrontPitch;
        FrontSide = other.FrontSide;
        Still = other.Still;
        Wings = other.Wings;
        Verve = other.Verve;
        other.Feet.CopyTo(Feet, 0);
    }
}

/// <summary>What is asked of a foot on top of its steps.</summary>
internal struct FootLayer
{
    /// <summary>How far it goes from where the steps have it, metres.</summary>
    public Vector3 Way;

    /// <summary>Toes down, radians.</summary>
    public float Pitch;

    /// <summary>How far its leg, if that is out to the side, lies over about the line from hip to foot, radians, the knee ahead: upright over that line it carries the body.</summary>
    public float Lean;

    /// <summary>How far it stands no longer: a leg that is folded under the body comes near its place as it can, 0..1.</summary>
    public float Loose;

    /// <summary>How far it has left the ground with the part of the trunk that its leg hangs on, 0..1: it goes along with that.</summary>
    public float Carried;

    /// <summary>Where its ball is to be instead, model space.</summary>
    public Vector3 Aim;

    /// <summary>Share of that, 0..1.</summary>
    public float AimFraction;
}
