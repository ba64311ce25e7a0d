@echo off
rem A double click opens the course; the first start sets it up. Words are passed on to start.py.
cd /d "%~dp0"
py -3 -c "" >nul 2>nul
if not errorlevel 1 (
  py -3 start.py %*
  goto end
)
rem The Store's alias of `python` is no Python: it fails here.
python -c "" >nul 2>nul
if not errorlevel 1 (
  python start.py %*
  goto end
)
echo There is no Python here. Install one from https://www.python.org/downloads/ : take "Windows installer (64-bit)".
echo Then double-click this file again.
cmd /c exit 1
:end
if errorlevel 1 pause
