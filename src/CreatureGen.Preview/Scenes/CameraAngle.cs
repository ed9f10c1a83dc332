using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Scenes;

/// <summary>The direction from which a camera looks at what it shows.</summary>
/// <param name="AzimuthDegrees">0 is in front (+Z), 90 at the creature's left (+X), 180 behind.</param>
/// <param name="ElevationDegrees">0 is level, 90 straight above.</param>
public readonly record struct CameraAngle(double AzimuthDegrees, double ElevationDegrees)
{
    /// <summary>Unit vector from what is shown to the camera.</summary>
    public Vector3 TowardsCamera
    {
        get
        {
            double azimuth = Scalar.Radians(AzimuthDegrees);
            double elevation = Scalar.Radians(ElevationDegrees);
            double level = PortableMath.Cos(elevation);
            return new Vector3(
                (float)(PortableMath.Sin(azimuth) * level),
                (float)PortableMath.Sin(elevation),
                (float)(PortableMath.Cos(azimuth) * level));
        }
    }
}
