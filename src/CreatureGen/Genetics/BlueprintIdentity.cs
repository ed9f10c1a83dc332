using System.Text;
using CreatureGen.Blueprints;

namespace CreatureGen.Genetics;

/// <summary>A number by which a creature is known in lineages and names of files.</summary>
public static class BlueprintIdentity
{
    /// <summary>FNV-1a of 64 bits over the blueprint's text without its lineage: equal creatures have one number, whoever their parents were.</summary>
    /// <remarks>Source: G. Fowler, L. C. Noll, K.-P. Vo, "The FNV non-cryptographic hash algorithm".</remarks>
    public static ulong Of(CreatureBlueprint blueprint)
    {
        ulong hash = 14695981039346656037;
        foreach (byte b in Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint with { Lineage = null })))
        {
            hash = unchecked((hash ^ b) * 1099511628211);
        }

        return hash;
    }
}
