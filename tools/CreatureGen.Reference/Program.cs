using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;

namespace CreatureGen.Reference;

/// <summary>Works on the documentation of assemblies: <c>trim ASSEMBLY XML</c> leaves what is public, <c>pages FOLDER ASSEMBLY...</c> writes it as Markdown.</summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        switch (arguments)
        {
            case ["trim", string assembly, string xml]:
                (int kept, int removed) = OpenDocumentation.Trim(Load(assembly), xml);
                Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{xml}: {kept} entries, {removed} of internals removed"));
                return 0;
            case ["pages", string folder, .. var assemblies] when assemblies.Length > 0:
                Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{folder}: {ReferencePages.Write(folder, assemblies.Select(path => (Load(path), Path.ChangeExtension(path, ".xml"))).ToArray())} pages"));
                return 0;
            default:
                Console.Error.WriteLine("expected trim ASSEMBLY XML, or pages FOLDER ASSEMBLY...");
                return 2;
        }
    }

    private static Assembly Load(string path) => Assembly.LoadFrom(Path.GetFullPath(path));
}
