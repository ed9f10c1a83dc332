using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>What came of checking many creatures, as JSON. The names are a contract.</summary>
internal static class VerificationJson
{
    /// <summary>Writes it.</summary>
    public static void Write(TextWriter output, Verification verification) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("checked", verification.Checked);
        json.WriteNumber("failed", verification.Failed);
        json.WriteNumber("selfIntersecting", verification.SelfIntersecting);
        json.WriteNumber("piecesCrossing", verification.PiecesCrossing);
        if (verification.Looked.Count > 0)
        {
            json.WriteNumber("levelsCrossing", verification.Looked.Count(creature => creature.Everywhere!.Levels.All > 0));
            json.WriteNumber("posesCrossing", verification.Looked.Sum(creature => creature.Everywhere!.CrossingPoses));
            json.WriteNumber("poses", verification.Looked.Sum(creature => creature.Everywhere!.Poses));
        }

        json.WriteStartArray("problems");
        foreach (VerificationProblem problem in verification.Problems)
        {
            json.WriteStartObject();
            json.WriteString("kind", WordList<LocomotionKind>.Instance[problem.Kind]);
            json.WriteString("seed", SeedText.Of(problem.Specimen.Seed));
            if (problem.Specimen.Individual is ulong individual)
            {
                json.WriteString("individual", SeedText.Of(individual));
            }

            json.WriteString("invariant", problem.Invariant);
            json.WriteString("detail", problem.Detail);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }));
}
