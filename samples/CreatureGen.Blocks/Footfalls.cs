using System;
using System.Linq;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Sampling;

namespace CreatureGen.Blocks;

/// <summary>Single Bone Angular Rule on a clip: above, how fast each leg of a walk sweeps back, with the footsteps that the rule finds; below, how fast the turning of its hips changes, with the moments of a rule of peaks.</summary>
internal static class Footfalls
{
    private const int Width = 1440;
    private const int Row = 56;
    private const int Left = 130;
    private static readonly Pixel[] ink = [new(52, 62, 84), new(120, 150, 190), new(214, 60, 50), new(90, 160, 90)];

    /// <summary>A row for each curve.</summary>
    public static Picture Plot()
    {
        var creature = CreatureGenerator.Generate(22, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        Clip clip = ClipBaker.Bake(creature).First(clip => clip.Events.Count(e => e.Name == "footstep") > 2);
        AngularFinding steps = AngularEventDetector.Find(clip, creature.Skeleton, AngularRules.Footstep);
        AngularFinding swings = AngularEventDetector.Find(clip, creature.Skeleton, AngularRules.Whoosh with { ThresholdPower = 2, Joints = [], Roles = [Rigging.JointRole.Hip] });
        var picture = new Picture(Width, Row * (steps.Curves.Count + swings.Curves.Count), PixelLayout.Rgb);
        picture.Fill(new Pixel(250, 249, 245));
        int top = 0;
        foreach ((AngularFinding finding, AngularCurve curve) in steps.Curves.Select(c => (steps, c)).Concat(swings.Curves.Select(c => (swings, c))))
        {
            Draw(picture, clip, curve, top);
            foreach (ClipEvent found in finding.Events.Where(e => e.Joint == curve.Joint))
            {
                picture.Fill(ink[2], Left + (int)(found.Time / clip.Duration * (Width - Left - 3)), top + 4, 3, Row - 8);
            }

            top += Row;
        }

        return picture;
    }

    private static void Draw(Picture picture, IClip clip, AngularCurve curve, int top)
    {
        float most = curve.Signal.ToArray().Max(MathF.Abs);
        int middle = top + (Row / 2);
        for (int x = Left; x < Width; x++)
        {
            float at = (x - Left) * (float)curve.Signal.Length / (Width - Left);
            float value = float.Lerp(curve.Signal[(int)at], curve.Signal[((int)at + 1) % curve.Signal.Length], at % 1f) / most * ((Row / 2) - 4);
            picture.Fill(ink[1], x, value > 0f ? middle - (int)value : middle, 1, Math.Max(1, (int)MathF.Abs(value)));
        }

        picture.Fill(ink[0], Left, middle, Width - Left, 1);
        Label.Draw(picture, curve.Joint, 8, middle - 4, LabelSize.Small, ink[0]);
    }
}
