using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Tests.SampleProjects;
using Xunit;

namespace CreatureGen.Tests.Documents;

/// <summary>The documents as a static site, as <c>tools/site/build.sh</c> makes it.</summary>
public sealed class SiteTests
{
    /// <summary>npm fetches what makes pages of Markdown.</summary>
    [Fact(Explicit = true)]
    public void The_site_has_every_document_and_namespace_and_each_link_leads_to_a_place_that_is_there()
    {
        string site = Directory.CreateTempSubdirectory("creaturegen-site-").FullName;
        try
        {
            SampleFiles.Run(SampleFiles.At("."), "bash", ["tools/site/build.sh", site]);
            Dictionary<string, string> pages = Directory.GetFiles(site, "*.html", SearchOption.AllDirectories).ToDictionary(path => path, File.ReadAllText);
            Assert.All(DocumentText.All, document => Assert.Contains(Path.Combine(site, document == "README.md" ? "index.html" : Path.ChangeExtension(document, ".html")), pages.Keys));
            string reference = File.ReadAllText(Path.Combine(site, "docs/api/index.html"));
            Assert.All(typeof(CreatureGenerator).Assembly.GetExportedTypes().Select(type => type.Namespace!).Distinct(), name => Assert.Contains(name, reference, StringComparison.Ordinal));
            int links = 0;
            foreach ((string path, string text) in pages)
            {
                foreach (Match link in Regex.Matches(Regex.Replace(text, "<(pre|code)[^>]*>.*?</\\1>", "", RegexOptions.Singleline), "(?:href|src)=\"([^\"]*)\""))
                {
                    string[] parts = link.Groups[1].Value.Split('#');
                    if (Regex.IsMatch(parts[0], "^[a-z]+:"))
                    {
                        continue;
                    }

                    string target = parts[0].Length == 0 ? path : Path.GetFullPath(parts[0], Path.GetDirectoryName(path)!);
                    Assert.True(File.Exists(target), $"{path}: {link.Value} leads nowhere");
                    Assert.True(parts.Length == 1 || pages[target].Contains($" id=\"{parts[1]}\"", StringComparison.Ordinal), $"{path}: {link.Value} leads to no heading");
                    links++;
                }
            }

            Assert.True(links > 300);
        }
        finally
        {
            Directory.Delete(site, recursive: true);
        }
    }

    [Fact(Explicit = true)]
    public void A_link_that_leads_nowhere_ends_the_making_of_the_site()
    {
        if (!Directory.Exists(SampleFiles.At("tools/site/node_modules")))
        {
            SampleFiles.Run(SampleFiles.At("."), "npm", ["ci", "--prefix", "tools/site", "--prefer-offline"]);
        }

        string root = Directory.CreateTempSubdirectory("creaturegen-site-").FullName;
        Directory.CreateDirectory(Path.Combine(root, "docs"));
        File.WriteAllText(Path.Combine(root, "README.md"), "# One\n[other](docs/other.md) [place](docs/other.md#there)\n");
        File.WriteAllText(Path.Combine(root, "docs/other.md"), "# Other\n## There\n");
        Assert.Contains("2 links, 0 broken", SampleFiles.Run(root, "node", [SampleFiles.At("tools/site/build.mjs"), Path.Combine(root, "site"), root]), StringComparison.Ordinal);
        File.WriteAllText(Path.Combine(root, "docs/other.md"), "# Other\n## Elsewhere\n");
        using Process broken = SampleFiles.Start(root, "node", [SampleFiles.At("tools/site/build.mjs"), Path.Combine(root, "site"), root]);
        Assert.Contains("README.md: docs/other.md#there leads nowhere", broken.StandardError.ReadToEnd(), StringComparison.Ordinal);
        broken.WaitForExit();
        Assert.Equal(1, broken.ExitCode);
        Directory.Delete(root, recursive: true);
    }
}
