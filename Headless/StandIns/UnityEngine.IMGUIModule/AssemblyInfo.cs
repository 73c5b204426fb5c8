using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("UnityEditor.CoreModule")]
[assembly: InternalsVisibleTo("UnityEditor.AssetPipelineEditorModule")]
