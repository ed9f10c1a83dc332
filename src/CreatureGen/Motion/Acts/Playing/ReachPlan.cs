using System;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How the trunk helps a tool to its target: added to the channels as the tool is on its way.</summary>
internal struct ReachPlan
{
    /// <summary>Number of ways in which the trunk helps.</summary>
    public const int Count = 7;

    public float Ahead;
    public float Aside;
    public float Yaw;
    public float Pitch;
    public float ForeDown;
    public float HindDown;
    public float BackPitch;

    /// <summary>A way by its number.</summary>
    public float this[int index]
    {
        readonly get => index switch { 0 => Ahead, 1 => Yaw, 2 => BackPitch, 3 => ForeDown, 4 => HindDown, 5 => Pitch, _ => Aside };
        set
        {
            switch (index)
            {
                case 0: Ahead = value; break;
                case 1: Yaw = value; break;
                case 2: BackPitch = value; break;
                case 3: ForeDown = value; break;
                case 4: HindDown = value; break;
                case 5: Pitch = value; break;
                default: Aside = value; break;
            }
        }
    }

    /// <summary>Adds a share of it, all of it at the most, to channels of an act to the left; sides of an act to the right are those of the creature all the same.</summary>
    public readonly void AddTo(float[] values, float fraction, float side)
    {
        fraction = Math.Min(fraction, 1f);
        values[(int)ActChannel.Ahead] += Ahead * fraction;
        values[(int)ActChannel.Aside] += Aside * fraction * side;
        values[(int)ActChannel.Yaw] += Yaw * fraction * side;
        values[(int)ActChannel.Pitch] += Pitch * fraction;
        values[(int)ActChannel.ForeDown] += ForeDown * fraction;
        values[(int)ActChannel.HindDown] += HindDown * fraction;
        values[(int)ActChannel.BackPitch] += BackPitch * fraction;
    }
}
