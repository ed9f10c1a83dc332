using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace CreatureGen.Tests.Conventions;

/// <summary>In which folder of the library each type is declared, as its sources say: public types stand in the namespace where users look for them, so that the namespace does not tell.</summary>
internal sealed partial class TypeFolders
{
    /// <summary>Folders whose public types, and those of all folders in them, stand in one namespace: a door of the library. The nearest one upwards counts.</summary>
    private static readonly string[] Doors = ["Motion/Toolkit", "Motion/Metrics", "Motion"];

    private readonly Dictionary<string, string> folders = new(StringComparer.Ordinal);

    private TypeFolders()
    {
    }

    /// <summary>The folder of a type; null for one that no source declares.</summary>
    /// <param name="name">With its namespace, without type arguments.</param>
    public string? FolderOf(string? name) => name != null && folders.TryGetValue(name.Split('`')[0], out string? folder) ? folder : null;

    /// <summary>Reads the sources.</summary>
    public static TypeFolders Read()
    {
        var map = new TypeFolders();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen", "*.cs"))
        {
            string code = SourceText.CodeOf(RepositoryFiles.Text(path));
            string space = NamespaceOf(code);
            foreach (Match match in Declaration().Matches(code))
            {
                map.folders[$"{space}.{match.Groups["name"].Value}"] = FolderOfFile(path);
            }
        }

        return map;
    }

    /// <summary>The folder of a source file, below that of the library; <c>.</c> for the library's own.</summary>
    public static string FolderOfFile(string path)
    {
        string folder = Path.GetDirectoryName(path)!.Replace('\\', '/');
        return folder == "src/CreatureGen" ? "." : folder["src/CreatureGen/".Length..];
    }

    /// <summary>Whether a namespace is that of a door.</summary>
    public static bool IsDoor(string space) => Doors.Any(d => space == SpaceOf(d));

    /// <summary>The namespace that code says it is in.</summary>
    public static string NamespaceOf(string code) => NamespaceLine().Match(code).Groups[1].Value;

    /// <summary>The namespace that a file of a folder should be in: that of its door when it declares public types, else that of its folder.</summary>
    public static string ExpectedNamespace(string folder, string code)
    {
        string? door = Doors.FirstOrDefault(d => folder == d || folder.StartsWith(d + "/", StringComparison.Ordinal));
        bool open = Declaration().Matches(code).Any(m => m.Groups["access"].Value == "public ");
        return SpaceOf(open && door != null ? door : folder);
    }

    private static string SpaceOf(string folder) => folder == "." ? "CreatureGen" : "CreatureGen." + folder.Replace('/', '.');

    [GeneratedRegex(@"^namespace ([\w.]+);", RegexOptions.Multiline)]
    private static partial Regex NamespaceLine();

    [GeneratedRegex(@"^(?<access>public |internal )?(?:static |sealed |readonly |abstract |partial |ref |unsafe )*(?:record struct|record class|class|struct|record|enum|interface|delegate [\w<>?\[\]]+) (?<name>\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
