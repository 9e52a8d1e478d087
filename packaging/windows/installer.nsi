; SPDX-License-Identifier: GPL-3.0-or-later
; The installer of Windows: for the user who runs it, without an administrator, in English and Russian.
; makensis -DVERSION=… -DFOLDER=what is installed -DICON=… -DOUT=….exe installer.nsi
; Silent: setup.exe /S [/D=C:\folder], and uninstall.exe /S.
Target amd64-unicode
!include MUI2.nsh

Name "Sparkout"
OutFile "${OUT}"
RequestExecutionLevel user
InstallDir "$LOCALAPPDATA\Programs\Sparkout"
InstallDirRegKey HKCU "Software\Sparkout" "InstallDir"
SetCompressor /SOLID lzma
ManifestSupportedOS Win10
BrandingText "Sparkout ${VERSION}"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define CLASSES "Software\Classes"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\Sparkout"

!insertmacro MUI_PAGE_LICENSE "${FOLDER}/licences/LICENSE"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\sparkout.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "Russian"

LangString Kind ${LANG_ENGLISH} "Sparkout project"
LangString Kind ${LANG_RUSSIAN} "Проект Sparkout"
LangString Pack ${LANG_ENGLISH} "Sparkout pack"
LangString Pack ${LANG_RUSSIAN} "Набор Sparkout"
LangString Lesson ${LANG_ENGLISH} "Sparkout laboratory work"
LangString Lesson ${LANG_RUSSIAN} "Лабораторная работа Sparkout"
LangString Work ${LANG_ENGLISH} "Student's work of a Sparkout laboratory work"
LangString Work ${LANG_RUSSIAN} "Работа студента по лабораторной работе Sparkout"

VIProductVersion "${VERSION}.0"
VIAddVersionKey /LANG=${LANG_ENGLISH} "ProductName" "Sparkout"
VIAddVersionKey /LANG=${LANG_ENGLISH} "FileDescription" "Sparkout: installer"
VIAddVersionKey /LANG=${LANG_ENGLISH} "FileVersion" "${VERSION}"
VIAddVersionKey /LANG=${LANG_ENGLISH} "ProductVersion" "${VERSION}"
VIAddVersionKey /LANG=${LANG_ENGLISH} "LegalCopyright" "GPL-3.0-or-later"

; A double click on a file of that kind opens it.
!macro Associate SUFFIX CLASS WORDS
    WriteRegStr HKCU "${CLASSES}\${SUFFIX}" "" "${CLASS}"
    WriteRegStr HKCU "${CLASSES}\${CLASS}" "" "${WORDS}"
    WriteRegStr HKCU "${CLASSES}\${CLASS}\DefaultIcon" "" "$INSTDIR\sparkout.exe,0"
    WriteRegStr HKCU "${CLASSES}\${CLASS}\shell\open\command" "" '"$INSTDIR\sparkout.exe" "%1"'
!macroend
!macro Dissociate SUFFIX CLASS
    ReadRegStr $0 HKCU "${CLASSES}\${SUFFIX}" ""
    StrCmp $0 "${CLASS}" 0 +2
    DeleteRegKey HKCU "${CLASSES}\${SUFFIX}"
    DeleteRegKey HKCU "${CLASSES}\${CLASS}"
!macroend
!macro RemoveFolders
    RMDir /r "$INSTDIR\examples"
    RMDir /r "$INSTDIR\lessons"
    RMDir /r "$INSTDIR\fonts"
    RMDir /r "$INSTDIR\translations"
    RMDir /r "$INSTDIR\licences"
!macroend

Section
    SetOutPath "$INSTDIR"
    !insertmacro RemoveFolders ; what an older version has put there and this one has no more
    File /r "${FOLDER}/*"
    CreateShortcut "$SMPROGRAMS\Sparkout.lnk" "$INSTDIR\sparkout.exe"
    !insertmacro Associate ".sparkout" "Sparkout.Project" "$(Kind)"
    !insertmacro Associate ".sparkout-pack" "Sparkout.Pack" "$(Pack)"
    !insertmacro Associate ".sparkout-lesson" "Sparkout.Lesson" "$(Lesson)"
    !insertmacro Associate ".sparkout-work" "Sparkout.Work" "$(Work)"
    WriteRegStr HKCU "Software\Sparkout" "InstallDir" "$INSTDIR"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "Sparkout"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\sparkout.exe"
    WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
SectionEnd

Section "Uninstall" ; what the user has put into the folder stays, and so do settings
    !insertmacro Dissociate ".sparkout" "Sparkout.Project"
    !insertmacro Dissociate ".sparkout-pack" "Sparkout.Pack"
    !insertmacro Dissociate ".sparkout-lesson" "Sparkout.Lesson"
    !insertmacro Dissociate ".sparkout-work" "Sparkout.Work"
    !insertmacro RemoveFolders
    Delete "$INSTDIR\sparkout.exe"
    Delete "$INSTDIR\sparkout-cli.exe"
    Delete "$INSTDIR\qt.conf"
    Delete "$INSTDIR\README.txt"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    Delete "$SMPROGRAMS\Sparkout.lnk"
    DeleteRegKey HKCU "${UNINSTALL}"
    DeleteRegKey HKCU "Software\Sparkout"
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
SectionEnd
