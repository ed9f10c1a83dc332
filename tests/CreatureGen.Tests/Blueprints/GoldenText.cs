using System;
using System.Globalization;
using CreatureGen.Blueprints;

namespace CreatureGen.Tests.Blueprints;

/// <summary>Text that must not change while the version of blueprints stays: files that people keep are written like this.</summary>
internal static class GoldenText
{
    /// <summary>The text of <see cref="Samples.Small"/>.</summary>
    public static string Small => Text.Replace("FORMAT", Number(BlueprintFormat.Current), StringComparison.Ordinal).Replace("ALGORITHM", Number(CreatureBlueprint.CurrentAlgorithm), StringComparison.Ordinal);

    private const string Text = """
        {
          "version": FORMAT,
          "algorithm": ALGORITHM,
          "seed": "18446744073709551615",
          "kind": "flying",
          "plan": "flapping",
          "scale": 1.25,
          "triangleBudget": 20000,
          "body": {
            "blend": {
              "bodies": [
                { "name": "canine", "torso": 1, "head": 1, "tail": 1 }
              ],
              "face": "canine",
              "skin": "canine",
              "manner": "canine"
            },
            "proportions": {
              "head": 1,
              "snout": 1,
              "neck": 1,
              "neckGirth": 1,
              "girth": 1,
              "belly": 1,
              "chest": 1,
              "hump": 1,
              "rump": 1,
              "tail": 1,
              "tailGirth": 1,
              "depth": 1,
              "width": 1
            },
            "posture": {
              "head": 0,
              "neck": 0,
              "torso": 0,
              "tail": 0,
              "trunk": 0,
              "neckBend": 0,
              "tailBend": 0
            },
            "slices": [
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 },
              { "width": 1, "height": 1, "length": 1 }
            ],
            "elevation": 0.5,
            "shell": { "style": "none", "ring": 24, "rows": 20, "columns": 6, "rise": 0 },
            "annuli": { "ring": 41, "depth": 0 },
            "disc": { "sweep": 0, "curl": 0 }
          },
          "head": {
            "bumps": [
              { "ring": 9.2, "segment": 4.2, "ringSpread": 1.6, "segmentSpread": 1.3, "amount": 0.1 },
              { "ring": 8.4, "segment": 1, "ringSpread": 1.5, "segmentSpread": 1.6, "amount": -0.05 }
            ],
            "muzzleSquareness": 2.2,
            "eyes": {
              "style": "round",
              "ring": 9.6,
              "segment": 5.2,
              "radius": 0.04,
              "sink": 0.6,
              "forward": 0.5,
              "upperLid": 1,
              "lowerLid": 1.1,
              "lidTilt": 0
            },
            "mouth": { "cornerRing": 8, "opening": 0.1, "smile": -0.25, "teeth": 0.14, "tongue": "forked" },
            "nostrilSize": 0
          },
          "tail": { "style": "fork", "size": 0.29, "fork": 1.5, "lobe": 0 },
          "legs": [
            {
              "archetype": "arm",
              "stance": "hanging",
              "socket": { "ring": 26, "segment": 8, "rows": 4, "columns": 4 },
              "thickness": 0.1,
              "length": 0.5,
              "reach": 0.5,
              "azimuth": 0,
              "shear": 0,
              "slimness": 1,
              "stoutness": 1,
              "footSize": 1,
              "kneeRise": 1,
              "toes": 3,
              "clawLength": 0,
              "foot": "plain"
            },
            {
              "archetype": "plantigradeHind",
              "stance": "standing",
              "socket": { "ring": 39, "segment": 8, "rows": 4, "columns": 4 },
              "thickness": 0.3333333333333333,
              "length": 0.5,
              "reach": 0.5,
              "azimuth": 0,
              "shear": 0,
              "slimness": 1,
              "stoutness": 1,
              "footSize": 1,
              "kneeRise": 1,
              "toes": 3,
              "clawLength": 0,
              "foot": "plain"
            }
          ],
          "wings": [
            {
              "style": "bat",
              "socket": { "ring": 24, "segment": 5, "rows": 6, "columns": 2 },
              "span": 1.4,
              "chord": 0.5,
              "rise": 0.5,
              "sweep": 0.1
            }
          ],
          "insectWings": [
            {
              "ring": 26,
              "segment": 2.6,
              "length": 1,
              "width": 0.2,
              "azimuth": 0,
              "elevation": 0.6,
              "style": "blade"
            }
          ],
          "fins": [
            {
              "place": "dorsal",
              "style": "sail",
              "socket": { "ring": 32, "segment": 31, "rows": 8, "columns": 2 },
              "length": 0.2,
              "width": 0,
              "drop": 0,
              "sweep": 0.4
            }
          ],
          "ears": [
            {
              "socket": { "ring": 13, "segment": 2, "rows": 2, "columns": 2 },
              "length": 0.15,
              "width": 0.06,
              "outward": 0.4,
              "upward": 1,
              "forward": -0.25,
              "droop": 0,
              "roundness": 0
            }
          ],
          "features": [
            {
              "kind": "spike",
              "ring": 30,
              "segment": 0,
              "length": 0.1,
              "radius": 0.03,
              "outward": 1,
              "upward": 0,
              "forward": 0,
              "sideward": 0,
              "bendUp": 0,
              "bendForward": 0,
              "bendSide": 0,
              "flatness": 1,
              "taper": 1
            }
          ],
          "manes": [
            {
              "ring": 16,
              "lastRing": 24,
              "segment": 0,
              "lastSegment": 8,
              "rows": 4,
              "columns": 4,
              "length": 0.15,
              "growth": 1,
              "width": 0.03,
              "rise": 0.4,
              "fall": 0.5,
              "hang": 0
            }
          ],
          "frills": [
            {
              "ring": 14,
              "spread": 9,
              "length": 0.3,
              "tilt": 0.7,
              "bend": 0,
              "thickness": 0.02,
              "points": 6,
              "scallop": 0.1
            }
          ],
          "coat": {
            "base": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "back": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "belly": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "limb": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "pattern": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "accent": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "claw": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "horn": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "muzzle": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "mouth": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "tongue": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "iris": { "lightness": 0.6, "chroma": 0.05, "hue": 1.2 },
            "patternKind": "plain",
            "patternScale": 1,
            "patternStrength": 0,
            "patternSeed": 0,
            "marks": 0
          }
        }

        """;

    private static string Number(int value) => value.ToString(CultureInfo.InvariantCulture);
}
